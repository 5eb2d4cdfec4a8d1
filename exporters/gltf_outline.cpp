#include "exporters/gltf_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
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

/// Whether any shape has a member called `key`.
bool is_read(const Shape& shape, std::string_view key) {
  if (shape.item) return is_read(*shape.item, key);
  return std::ranges::any_of(shape.members, [&](const Member& member) {
    return member.key == key || is_read(*member.shape, key);
  });
}

/// Leaves out what a value of its shape does not have, and refuses what it must not be.
class Pruner {
 public:
  explicit Pruner(std::string_view name) : name_(name) {}

  Json pruned(Json&& value, const Shape& shape, const std::string& path) const {
    if (shape.kind == Kind::kObject) return object(std::move(value), shape, path);
    if (shape.kind == Kind::kList) return list(std::move(value), shape, path);
    if (shape.kind == Kind::kRefused) {
      fail_gltf(name_, path, "is not read; export without sparse accessors");
    }
    check_plain(value, shape.kind, path);
    return std::move(value);
  }

 private:
  Json object(Json&& value, const Shape& shape, const std::string& path) const {
    if (!value.is_object()) fail_gltf(name_, path, "must be an object");
    Json kept = Json::object();
    for (const auto& [key, member, required] : shape.members) {
      const std::string member_path =
          path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
      const auto found = value.find(key);
      if (found != value.end()) {
        kept[std::string(key)] = pruned(std::move(*found), *member, member_path);
      } else if (required) {
        fail_gltf(name_, member_path, "is missing; export the file again");
      }
    }
    return kept;
  }

  Json list(Json&& value, const Shape& shape, const std::string& path) const {
    if (!value.is_array() || (shape.count > 0 && value.size() != shape.count)) {
      fail_gltf(
          name_, path,
          shape.count > 0 ? fmt::format("must be {} numbers", shape.count) : "must be a list");
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      value[i] = pruned(std::move(value[i]), *shape.item, fmt::format("{}[{}]", path, i));
    }
    return std::move(value);
  }

  void check_plain(const Json& value, Kind kind, const std::string& path) const {
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

/// The 4 bytes at `at` as an unsigned integer.
std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

/// A chunk's type and what it holds.
struct Chunk {
  std::uint32_t type = 0;
  std::string_view content;
};

/// The chunk whose header begins at byte `at`.
Chunk chunk_at(std::string_view bytes, std::size_t at, std::string_view name) {
  constexpr std::size_t kHeader = 8;
  const auto place = fmt::format("byte {}", at);
  if (bytes.size() - at < kHeader) {
    fail_gltf(name, place, "begins a chunk whose header is cut short; export it again");
  }
  const std::uint64_t length = word(bytes, at), left = bytes.size() - at - kHeader;
  if (length > left) {
    fail_gltf(name, place,
              fmt::format("begins a chunk of {} bytes, of which {} are there; the "
                          "file is cut short",
                          length, left));
  }
  return {word(bytes, at + 4), bytes.substr(at + kHeader, length)};
}

}  // namespace

void fail_gltf(std::string_view name, std::string_view place, std::string_view problem) {
  throw Error(fmt::format("{}: {} {}", name, place.empty() ? "the document" : place, problem));
}

std::string quoted_gltf(std::string_view text) {
  constexpr std::size_t kMost = 60;
  return Json(text.substr(0, kMost)).dump(-1, ' ', true, Json::error_handler_t::replace);
}

GltfChunks gltf_chunks(std::string_view bytes, std::string_view name) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  constexpr std::size_t kHeader = 12;
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < kHeader) {
    fail_gltf(name, "byte 4", "ends the file within its header; export it again");
  }
  if (word(bytes, 4) != 2) {
    fail_gltf(name, "byte 4",
              fmt::format("has version {} of glTF, not 2; export it as glTF 2.0", word(bytes, 4)));
  }
  if (word(bytes, 8) != bytes.size()) {
    fail_gltf(name, "byte 8",
              fmt::format("tells of {} bytes, but the file has {}; copy it again", word(bytes, 8),
                          bytes.size()));
  }
  const Chunk json = chunk_at(bytes, kHeader, name);
  if (json.type != kJson) {
    fail_gltf(name, "byte 16", "must begin with a JSON chunk; export it again");
  }
  const std::size_t end = kHeader + 8 + json.content.size();
  if (end == bytes.size()) return {json.content, {}};
  const Chunk binary = chunk_at(bytes, end, name);
  return {json.content, binary.type == kBinary ? binary.content : std::string_view()};
}

Json gltf_outline(std::string_view json, std::string_view name) {
  const auto keep = [](int, Json::parse_event_t event, Json& value) {
    return event != Json::parse_event_t::key || is_read(kRoot, value.get_ref<const std::string&>());
  };
  try {
    return Pruner(name).pruned(Json::parse(json, keep), kRoot, "");
  } catch (const Json::parse_error& e) {
    fail_gltf(name, fmt::format("byte {} of the text", e.byte),
              "is not JSON; is it a glTF file, whole?");
  } catch (const Json::exception& e) {  // a number beyond double
    const std::string_view what = e.what();
    fail_gltf(name, "the text", fmt::format("is not JSON: {}", what.substr(what.find(']') + 2)));
  }
}

}  // namespace lumaknot
