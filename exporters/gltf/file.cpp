#include "exporters/gltf/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "exporters/gltf/container.h"
#include "exporters/gltf/json.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::gltf {
namespace {

namespace fs = std::filesystem;

/// The extensions that don't affect the mesh, or that are supported.
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_basisu", "EXT_texture_webp",
    "EXT_texture_avif"};

bool is_known(std::string_view extension) {
  return extension.starts_with("KHR_materials_") ||
         std::ranges::find(kKnownExtensions, extension) != kKnownExtensions.end();
}

void check_version(const GltfModel& model, std::string_view name) {
  if (!model.version.starts_with("2.")) {
    fail_gltf(name, "asset.version",
              fmt::format("is {}, not 2.x; export it as glTF 2.0", quoted_gltf(model.version)));
  }
  const std::vector<std::string>& required = model.extensions_required;
  const auto unknown = std::ranges::find_if_not(required, is_known);
  if (unknown == required.end()) return;
  fail_gltf(name, fmt::format("extensionsRequired[{}]", unknown - required.begin()),
            fmt::format("is {}, which is not read; export without it", quoted_gltf(*unknown)));
}

/// The text of a URI, decoding %XX.
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

/// The bytes of `text` in base64 (RFC 4648, section 4); empty if it is not base64.
std::optional<std::string> base64_bytes(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i) values[(unsigned char)(kDigits[i])] = int(i);

  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : text) {
    const int value = values[(unsigned char)(digit)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | std::uint32_t(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += char(bits >> count);
  }
  return bytes;
}

/// Whether `text` names a file in the folder or below it, judging by the text alone.
bool is_name_below(std::string_view text) {
  const fs::path path(text);
  return !path.empty() && path.is_relative() && text.find_first_of(":\\") == text.npos &&
         text.find('\0') == text.npos && std::find(path.begin(), path.end(), "..") == path.end();
}

/// Whether the file at `path` is really below `folder`, following links.
bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Loads the buffers of a file, one after another.
class BufferLoader {
 public:
  BufferLoader(GltfFile& file, std::string_view binary, fs::path folder)
      : file_(file), binary_(binary), folder_(std::move(folder)) {}

  void load(const GltfBuffer& buffer) {
    const std::size_t number = file_.buffers.size();
    place_ = fmt::format("buffers[{}]", number);
    const std::string_view bytes = bytes_of(buffer, number);
    if (buffer.size > bytes.size()) {
      fail_gltf(file_.name, place_,
                fmt::format("has {} bytes, not the {} of its byteLength; export it again",
                            bytes.size(), buffer.size));
    }
    file_.buffers.push_back(bytes.substr(0, buffer.size));
  }

 private:
  std::string_view bytes_of(const GltfBuffer& buffer, std::size_t number) {
    if (!buffer.uri) {
      if (number == 0) return binary_;
      fail_gltf(file_.name, place_ + ".uri", "is missing; only buffers[0] of a .glb may omit it");
    }
    return buffer.uri->starts_with("data:") ? embedded(*buffer.uri, number) : beside(*buffer.uri);
  }

  /// RFC 2397, whatever the media type.
  std::string_view embedded(std::string_view uri, std::size_t number) {
    constexpr std::string_view kMark = ";base64,";
    const std::size_t mark = uri.substr(0, uri.find(',') + 1).rfind(kMark);
    std::optional<std::string> bytes;
    if (mark != uri.npos) bytes = base64_bytes(uri.substr(mark + kMark.size()));
    if (!bytes)
      fail_gltf(file_.name, place_ + ".uri", "is not a buffer in base64; export it again");
    return file_.own[std::to_string(number)] = std::move(*bytes);
  }

  std::string_view beside(const std::string& uri) {
    const std::string text = decoded_uri(uri);
    if (!is_name_below(text)) refuse(uri, "is not a file in the folder of this one; put it there");
    std::error_code error;
    const fs::path path = fs::canonical(folder_ / text, error);
    if (error || !fs::is_regular_file(path, error)) {
      refuse(uri, "does not exist; put it in this file's folder");
    }
    if (!is_below(path, fs::canonical(folder_, error))) {
      refuse(uri, "leads out of this file's folder; put a copy there");
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

}  // namespace

std::unique_ptr<const GltfFile> load_gltf(const fs::path& path, std::string_view name) {
  auto file = std::make_unique<GltfFile>();
  file->name = name;
  file->bytes = read_file(path, name);
  const GltfChunks chunks = gltf_chunks(file->bytes, name);
  file->model = gltf_model(chunks.json, name);
  check_version(file->model, name);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  BufferLoader loader(*file, chunks.binary, folder);
  for (const GltfBuffer& buffer : file->model.buffers) loader.load(buffer);
  return file;
}

}  // namespace lumaknot::gltf
