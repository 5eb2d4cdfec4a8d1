#include "exporters/gltf_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/error.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;

enum class Kind { kIndex, kSize, kBoolean, kText, kNumber, kList, kObject, kRefused };

struct Member;

/// What a value must be.
struct Shape {
  Kind kind = Kind::kObject;
  std::span<const Member> members = {};  ///< of an object; others are left out
  const Shape* item = nullptr;           ///< of a list
  std::size_t count = 0;                 ///< of a list's items; 0: any
};

struct Member {
  std::string_view key;
  const Shape* shape;
  bool required = false;
};

constexpr Shape kIndex{.kind = Kind::kIndex}, kSize{.kind = Kind::kSize};
constexpr Shape kBoolean{.kind = Kind::kBoolean}, kText{.kind = Kind::kText};
constexpr Shape kNumber{.kind = Kind::kNumber}, kRefused{.kind = Kind::kRefused};

constexpr Shape list_of(const Shape& item, std::size_t count = 0) {
  return {.kind = Kind::kList, .item = &item, .count = count};
}
constexpr Shape object_of(std::span<const Member> members) {
  return {.kind = Kind::kObject, .members = members};
}

constexpr Shape kIndices = list_of(kIndex), kTexts = list_of(kText);
constexpr Shape kThree = list_of(kNumber, 3), kFour = list_of(kNumber, 4);
constexpr Shape kSixteen = list_of(kNumber, 16);

constexpr Member kAssetMembers[]{{"version", &kText, true}};
constexpr Member kSceneMembers[]{{"nodes", &kIndices}};
constexpr Member kNodeMembers[]{{"children", &kIndices}, {"mesh", &kIndex},
                                {"matrix", &kSixteen},   {"translation", &kThree},
                                {"rotation", &kFour},    {"scale", &kThree}};
constexpr Member kAttributeMembers[]{
    {"POSITION", &kIndex}, {"NORMAL", &kIndex}, {"TEXCOORD_0", &kIndex}};
constexpr Shape kAttributes = object_of(kAttributeMembers);
constexpr Member kPrimitiveMembers[]{
    {"attributes", &kAttributes, true}, {"indices", &kIndex}, {"mode", &kIndex}};
constexpr Shape kPrimitive = object_of(kPrimitiveMembers), kPrimitives = list_of(kPrimitive);
constexpr Member kMeshMembers[]{{"primitives", &kPrimitives, true}};
constexpr Member kAccessorMembers[]{
    {"bufferView", &kIndex}, {"byteOffset", &kSize}, {"componentType", &kIndex, true},
    {"count", &kSize, true}, {"type", &kText, true}, {"normalized", &kBoolean},
    {"sparse", &kRefused}};
constexpr Member kViewMembers[]{{"buffer", &kIndex, true},
                                {"byteOffset", &kSize},
                                {"byteLength", &kSize, true},
                                {"byteStride", &kSize}};
constexpr Member kBufferMembers[]{{"byteLength", &kSize, true}, {"uri", &kText}};
constexpr Shape kAsset = object_of(kAssetMembers), kScene = object_of(kSceneMembers);
constexpr Shape kNode = object_of(kNodeMembers), kMesh = object_of(kMeshMembers);
constexpr Shape kAccessor = object_of(kAccessorMembers), kView = object_of(kViewMembers);
constexpr Shape kBuffer = object_of(kBufferMembers);
constexpr Shape kScenes = list_of(kScene), kNodes = list_of(kNode), kMeshes = list_of(kMesh);
constexpr Shape kAccessors = list_of(kAccessor), kViews = list_of(kView);
constexpr Shape kBuffers = list_of(kBuffer);
constexpr Member kRootMembers[]{{"asset", &kAsset, true},   {"extensionsRequired", &kTexts},
                                {"scene", &kIndex},         {"scenes", &kScenes},
                                {"nodes", &kNodes},         {"meshes", &kMeshes},
                                {"accessors", &kAccessors}, {"bufferViews", &kViews},
                                {"buffers", &kBuffers}};
constexpr Shape kRoot = object_of(kRootMembers);

/// Indices are ints in tinygltf; sizes stay so far below 2^64 that their sums can't overflow.
constexpr std::uint64_t kMostIndex = std::numeric_limits<int>::max();
constexpr std::uint64_t kMostSize = std::uint64_t(1) << 40;

/// Builds of a text what its shape has, and skips all else, however deep. (nlohmann's filter takes
/// quadratic time in the length of lists.)
class OutlineBuilder : public nlohmann::json_sax<Json> {
 public:
  explicit OutlineBuilder(std::string_view name) : name_(name) {}

  Json take() { return std::move(root_); }

  bool null() override { return scalar(nullptr); }
  bool boolean(bool value) override { return scalar(value); }
  bool number_integer(std::int64_t value) override { return scalar(value); }
  bool number_unsigned(std::uint64_t value) override { return scalar(value); }
  bool number_float(double value, const std::string&) override { return scalar(value); }
  bool string(std::string& value) override { return scalar(std::move(value)); }
  bool binary(Json::binary_t&) override { return scalar(nullptr); }
  bool start_object(std::size_t) override { return open(Json::object(), Kind::kObject); }
  bool start_array(std::size_t) override { return open(Json::array(), Kind::kList); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& key) override {
    if (skipped_levels_ > 0) return true;
    key_ = std::move(key);
    const auto& members = open_.back().shape->members;
    const auto found = std::ranges::find(members, key_, &Member::key);
    next_ = found == members.end() ? nullptr : found->shape;
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const Json::exception&) override {
    fail_gltf(name_, fmt::format("byte {} of the text", byte),
              "is not JSON; is it a glTF file, whole?");
  }

 private:
  struct Level {
    Json* value;
    const Shape* shape;
  };

  bool scalar(Json value) {
    if (skipped_levels_ == 0 && shape_here()) place(std::move(value));
    return true;
  }

  /// Begins an object or a list. Where there should be something else it stays empty.
  bool open(Json empty, Kind kind) {
    const Shape* shape = skipped_levels_ == 0 ? shape_here() : nullptr;
    Json* value = shape ? place(std::move(empty)) : nullptr;
    if (shape && shape->kind == kind) {
      open_.push_back({value, shape});
    } else {
      ++skipped_levels_;
    }
    return true;
  }

  bool close() {
    if (skipped_levels_ > 0) {
      --skipped_levels_;
    } else {
      open_.pop_back();
    }
    return true;
  }

  /// What the next value must be; nullptr: it is not read.
  const Shape* shape_here() const {
    if (open_.empty()) return &kRoot;
    const Shape* outer = open_.back().shape;
    return outer->item ? outer->item : next_;
  }

  Json* place(Json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    Json& outer = *open_.back().value;
    if (outer.is_object()) return &(outer[key_] = std::move(value));
    outer.push_back(std::move(value));
    return &outer.back();
  }

  std::string_view name_;
  Json root_;
  std::vector<Level> open_;
  std::size_t skipped_levels_ = 0;
  std::string key_;
  const Shape* next_ = nullptr;
};

/// Refuses what is not of its shape.
class ShapeCheck {
 public:
  explicit ShapeCheck(std::string_view name) : name_(name) {}

  void check(const Json& value, const Shape& shape, const std::string& path) const {
    if (shape.kind == Kind::kRefused) {
      fail_gltf(name_, path, "is not read; export without sparse accessors");
    }
    if (shape.kind == Kind::kObject) {
      check_object(value, shape, path);
    } else if (shape.kind == Kind::kList) {
      check_list(value, shape, path);
    } else {
      check_scalar(value, shape.kind, path);
    }
  }

 private:
  void check_object(const Json& value, const Shape& shape, const std::string& path) const {
    if (!value.is_object()) fail_gltf(name_, path, "must be an object");
    for (const auto& [key, member, required] : shape.members) {
      const auto found = value.find(key);
      if (found == value.end() && !required) continue;
      const std::string place = path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
      if (found == value.end()) fail_gltf(name_, place, "is missing; export the file again");
      check(*found, *member, place);
    }
  }

  void check_list(const Json& value, const Shape& shape, const std::string& path) const {
    if (!value.is_array() || (shape.count > 0 && value.size() != shape.count)) {
      fail_gltf(
          name_, path,
          shape.count > 0 ? fmt::format("must be {} numbers", shape.count) : "must be a list");
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      check(value[i], *shape.item, fmt::format("{}[{}]", path, i));
    }
  }

  void check_scalar(const Json& value, Kind kind, const std::string& path) const {
    const auto is_integer_to = [&](std::uint64_t most) {
      return value.is_number_unsigned() && value.get<std::uint64_t>() <= most;
    };
    const bool good = kind == Kind::kIndex     ? is_integer_to(kMostIndex)
                      : kind == Kind::kSize    ? is_integer_to(kMostSize)
                      : kind == Kind::kBoolean ? value.is_boolean()
                      : kind == Kind::kText    ? value.is_string()
                                               : value.is_number();
    if (good) return;
    constexpr std::string_view kNames[]{"an integer from 0 to 2^31 - 1",
                                        "an integer from 0 to 2^40", "true or false", "a text",
                                        "a number"};
    fail_gltf(name_, path, fmt::format("must be {}", kNames[std::size_t(kind)]));
  }

  std::string_view name_;
};

}  // namespace

void fail_gltf(std::string_view name, std::string_view place, std::string_view problem) {
  throw Error(fmt::format("{}: {} {}", name, place.empty() ? "the document" : place, problem));
}

std::string quoted_gltf(std::string_view text) {
  constexpr std::size_t kMost = 60;
  return Json(text.substr(0, kMost)).dump(-1, ' ', true, Json::error_handler_t::replace);
}

Json gltf_outline(std::string_view json, std::string_view name) {
  OutlineBuilder builder(name);
  Json::sax_parse(json, &builder);
  Json outline = builder.take();
  ShapeCheck(name).check(outline, kRoot, "");
  return outline;
}

}  // namespace lumaknot
