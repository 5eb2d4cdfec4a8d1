#include "exporters/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "exporters/gltf_container.h"
#include "exporters/gltf_elements.h"
#include "exporters/gltf_outline.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The extensions that change nothing of what is read here, or that are read.
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_basisu", "EXT_texture_webp",
    "EXT_texture_avif"};

bool is_known(std::string_view extension) {
  return extension.starts_with("KHR_materials_") ||
         std::ranges::find(kKnownExtensions, extension) != kKnownExtensions.end();
}

void check_version(const Json& outline, std::string_view name) {
  const auto& version = outline["asset"]["version"].get_ref<const std::string&>();
  if (!version.starts_with("2.")) {
    fail_gltf(name, "asset.version",
              fmt::format("is {}, not 2.x; export it as glTF 2.0", quoted_gltf(version)));
  }
  const Json required = outline.value("extensionsRequired", Json::array());
  for (std::size_t i = 0; i < required.size(); ++i) {
    const auto& extension = required[i].get_ref<const std::string&>();
    if (is_known(extension)) continue;
    fail_gltf(name, fmt::format("extensionsRequired[{}]", i),
              fmt::format("is {}, which is not read; export without it", quoted_gltf(extension)));
  }
}

/// Checks what tinygltf would refuse without saying where.
class ValueCheck {
 public:
  ValueCheck(const Json& outline, std::string_view name)
      : name_(name),
        views_(outline.value("bufferViews", Json::array())),
        accessors_(outline.value("accessors", Json::array())),
        meshes_(outline.value("meshes", Json::array())) {}

  void run() const {
    for (std::size_t i = 0; i < views_.size(); ++i) check_stride(i);
    for (std::size_t i = 0; i < accessors_.size(); ++i) check_type(i);
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      const Json& primitives = meshes_[m]["primitives"];
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        if (!primitives[p].contains("indices")) continue;
        check_indices(primitives[p]["indices"].get<std::size_t>(), m, p);
      }
    }
  }

 private:
  void check_stride(std::size_t i) const {
    constexpr std::size_t kMost = 252;
    const std::size_t stride = views_[i].value("byteStride", std::size_t(0));
    if (stride <= kMost && stride % 4 == 0) return;
    fail_gltf(name_, fmt::format("bufferViews[{}].byteStride", i),
              fmt::format("must be a multiple of 4 up to {}, got {}", kMost, stride));
  }

  void check_type(std::size_t i) const {
    constexpr std::array<std::string_view, 7> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                     "MAT2",   "MAT3", "MAT4"};
    const auto& type = accessors_[i]["type"].get_ref<const std::string&>();
    if (std::ranges::find(kTypes, type) == kTypes.end()) {
      fail_gltf(name_, fmt::format("accessors[{}].type", i),
                fmt::format("must be SCALAR, VEC2 or the like, got {}", quoted_gltf(type)));
    }
    const int component = accessors_[i]["componentType"].get<int>();
    if (component_size(component) == 0) {
      fail_gltf(name_, fmt::format("accessors[{}].componentType", i),
                fmt::format("must be 5120 to 5123, 5125 or 5126, got {}", component));
    }
  }

  void check_indices(std::size_t accessor, std::size_t m, std::size_t p) const {
    if (accessor >= accessors_.size()) {
      fail_gltf(name_, fmt::format("meshes[{}].primitives[{}].indices", m, p),
                fmt::format("is {}, but there are {} accessors; export it again", accessor,
                            accessors_.size()));
    }
    const std::size_t view = accessors_[accessor].value("bufferView", views_.size());
    if (view < views_.size()) return;
    fail_gltf(name_, fmt::format("accessors[{}].bufferView", accessor),
              fmt::format("must be below {}, the number of views; export it again", views_.size()));
  }

  std::string_view name_;
  Json views_, accessors_, meshes_;
};

/// The text of a URI, in which %XX stands for a byte.
std::string decoded_uri(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += char(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// Whether `text` names a file in the folder or below it, by the text alone.
bool is_name_below(std::string_view text) {
  const fs::path path(text);
  return !path.empty() && path.is_relative() && text.find_first_of(":\\") == text.npos &&
         text.find('\0') == text.npos && std::find(path.begin(), path.end(), "..") == path.end();
}

/// Whether the file at `path` really lies below `folder`, links followed.
bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Fills in the buffers of a file, one after another.
class BufferLoader {
 public:
  BufferLoader(GltfFile& file, std::string_view binary, fs::path folder)
      : file_(file), binary_(binary), folder_(std::move(folder)) {}

  void load(const Json& buffer) {
    const std::size_t number = file_.buffers.size();
    place_ = fmt::format("buffers[{}]", number);
    const auto size = buffer["byteLength"].get<std::size_t>();
    const std::string_view bytes = bytes_of(buffer, number);
    if (size > bytes.size()) {
      fail_gltf(file_.name, place_,
                fmt::format("has {} bytes, not the {} of its byteLength; export it again",
                            bytes.size(), size));
    }
    file_.buffers.push_back(bytes.substr(0, size));
  }

 private:
  std::string_view bytes_of(const Json& buffer, std::size_t number) {
    if (!buffer.contains("uri")) {
      if (number == 0) return binary_;
      fail_gltf(file_.name, place_ + ".uri",
                "is missing; only buffers[0] of a .glb may do without");
    }
    const auto& uri = buffer["uri"].get_ref<const std::string&>();
    return uri.starts_with("data:") ? embedded(uri, number) : beside(uri);
  }

  std::string_view embedded(const std::string& uri, std::size_t number) {
    std::vector<unsigned char> bytes;
    std::string type;
    if (uri.size() > std::size_t(std::numeric_limits<int>::max()) ||
        !tinygltf::DecodeDataURI(&bytes, type, uri, 0, false)) {
      fail_gltf(file_.name, place_ + ".uri", "is not a buffer in base64; export it again");
    }
    std::string& own = file_.own[std::to_string(number)];
    own.assign(bytes.begin(), bytes.end());
    return own;
  }

  std::string_view beside(const std::string& uri) {
    const std::string text = decoded_uri(uri);
    if (!is_name_below(text)) refuse(uri, "is not a file in the folder of this one; put it there");
    std::error_code error;
    const fs::path path = fs::canonical(folder_ / text, error);
    if (error || !fs::is_regular_file(path, error)) refuse(uri, "is not there; put it beside");
    if (!is_below(path, fs::canonical(folder_, error))) {
      refuse(uri, "leads out of the folder of this file; put a copy there");
    }
    const auto [entry, is_new] = file_.own.try_emplace(path.string());
    if (is_new) entry->second = read_file(path, file_.name);
    return entry->second;
  }

  [[noreturn]] void refuse(const std::string& uri, std::string_view why) const {
    fail_gltf(file_.name, place_ + ".uri", fmt::format("{} {}", quoted_gltf(uri), why));
  }

  GltfFile& file_;
  std::string_view binary_;
  fs::path folder_;
  std::string place_;
};

/// tinygltf's model of an outline, which has no buffers any more.
tinygltf::Model model_of(const Json& outline, std::string_view name) {
  const std::string text = outline.dump();
  if (text.size() > std::numeric_limits<unsigned>::max()) {
    fail_gltf(name, "the text", "is longer than 4 GiB; export to .glb");
  }
  tinygltf::TinyGLTF parser;
  tinygltf::Model model;
  std::string error, warning;
  const bool parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                 unsigned(text.size()), "", 0);
  std::ranges::replace(error, '\n', ' ');
  if (!parsed || !error.empty()) fail_gltf(name, "the document", "is not read: " + error);
  return model;
}

}  // namespace

std::unique_ptr<const GltfFile> load_gltf(const fs::path& path, std::string_view name) {
  auto file = std::make_unique<GltfFile>();
  file->name = name;
  file->bytes = read_file(path, name);
  const GltfChunks chunks = gltf_chunks(file->bytes, name);
  Json outline = gltf_outline(chunks.json, name);
  check_version(outline, name);
  ValueCheck(outline, name).run();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  BufferLoader loader(*file, chunks.binary, folder);
  for (const Json& buffer : outline.value("buffers", Json::array())) loader.load(buffer);
  outline.erase("buffers");
  file->model = model_of(outline, name);
  return file;
}

}  // namespace lumaknot
