/// The schema of a glTF file's JSON, as tables that also say where its values go.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "exporters/gltf/model.h"

namespace lumaknot::gltf {

enum class GltfKind {
  kIndex,
  kSize,
  kBoolean,
  kText,
  kNumber,
  kStride,
  kComponent,
  kType,
  kList,
  kObject,
  kRefused
};

/// A value that is neither a list nor an object.
struct GltfScalar {
  bool is_unsigned = false, is_number = false, is_boolean = false, is_text = false;
  std::uint64_t integer = 0;  ///< for a boolean 0 or 1
  double number = 0;
  std::string_view text = {};
};

struct GltfMember;

/// The requirements on a value, and where it goes.
struct GltfShape {
  GltfKind kind = GltfKind::kObject;
  std::span<const GltfMember> members = {};   ///< of an object; others are skipped
  const GltfShape* item = nullptr;            ///< of a list
  std::size_t count = 0;                      ///< of a list's items; 0: any
  void (*begin)(GltfModel& model) = nullptr;  ///< makes room for a list or object in the model
  void (*put)(GltfModel& model, const GltfScalar& value) = nullptr;  ///< takes a scalar
};

struct GltfMember {
  std::string_view key;
  GltfShape shape;
  bool required = false;
};

/// The shape of the whole document.
const GltfShape& gltf_root();

/// The names of GltfType's values, the first being number 1.
inline constexpr std::array<std::string_view, 7> kGltfTypes{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                            "MAT2",   "MAT3", "MAT4"};

/// The number of a type; beyond kGltfTypes' size: unknown name.
std::size_t gltf_type_number(std::string_view name);

}  // namespace lumaknot::gltf
