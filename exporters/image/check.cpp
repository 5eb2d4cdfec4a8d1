// PNG: W3C recommendation, section 5. JPEG: ITU-T T.81, annex B. TIFF 6.0, section 2. "OpenEXR File
// Layout" of its technical documents.
#include "exporters/image/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace lumaknot {
namespace {

constexpr std::string_view kCut = "the file is cut short, copy it again";

[[noreturn]] void fail(std::size_t at, std::string_view problem) {
  throw std::runtime_error(fmt::format("byte {}: {}", at, problem));
}

/// Unsigned integers of a file in one byte order. Reading beyond the end is refused.
class Numbers {
 public:
  Numbers(std::string_view bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

  /// The `size` bytes at `at`, 8 at most.
  std::uint64_t at(std::uint64_t at, std::size_t size) const {
    if (at > bytes_.size() || bytes_.size() - at < size) {
      fail(bytes_.size(), fmt::format("{} bytes expected at byte {}; {}", size, at, kCut));
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | (unsigned char)(bytes_[at + (big_endian_ ? i : size - 1 - i)]);
    }
    return value;
  }

 private:
  std::string_view bytes_;
  bool big_endian_;
};

/// Walks the chunks from IHDR to IEND.
void check_png(std::string_view bytes) {
  constexpr std::size_t kFirst = 8, kFrame = 12;
  const Numbers numbers(bytes, true);
  bool has_data = false;
  for (std::size_t at = kFirst;;) {
    const std::uint64_t length = numbers.at(at, 4);
    numbers.at(at + 4, 4);
    const std::string_view name = bytes.substr(at + 4, 4);
    if ((at == kFirst) != (name == "IHDR")) fail(at, "IHDR must be the first chunk");
    if (length > bytes.size() - at || bytes.size() - at - length < kFrame) {
      fail(at, fmt::format("a chunk of {} bytes, of which {} exist; {}", length + kFrame,
                           bytes.size() - at, kCut));
    }
    if (name == "IEND" && !has_data) fail(at, "the image ends without IDAT; export it again");
    if (name == "IEND") return;
    has_data = has_data || name == "IDAT";
    at += length + kFrame;
  }
}

/// The byte after the next marker from `at` on. Skips a scan's data, in which a byte 0 or a restart
/// follows 0xFF, and fill bytes.
std::size_t behind_marker(std::string_view bytes, std::size_t at) {
  constexpr unsigned char kFill = 0xFF, kStuffed = 0, kFirstRestart = 0xD0, kLastRestart = 0xD7;
  for (; (at = bytes.find('\xFF', at)) < bytes.size(); ++at) {
    if (at + 1 == bytes.size()) break;
    const auto code = (unsigned char)(bytes[at + 1]);
    const bool is_restart = code >= kFirstRestart && code <= kLastRestart;
    if (code != kFill && code != kStuffed && !is_restart) return at + 2;
  }
  fail(bytes.size(), fmt::format("the image's end marker is missing; {}", kCut));
}

/// Walks the segments and scans up to the end marker.
void check_jpeg(std::string_view bytes) {
  constexpr unsigned char kEnd = 0xD9, kScan = 0xDA, kTemporary = 0x01;
  const Numbers numbers(bytes, true);
  bool has_scan = false;
  for (std::size_t at = 2;;) {
    at = behind_marker(bytes, at);
    const auto code = (unsigned char)(bytes[at - 1]);
    if (code == kEnd && !has_scan) fail(at - 2, "the image ends without a scan; export it again");
    if (code == kEnd) return;
    has_scan = has_scan || code == kScan;
    if (code == kTemporary) continue;  // the only one without a length
    const std::uint64_t length = numbers.at(at, 2);
    if (length > bytes.size() - at) {
      fail(at, fmt::format("a segment of {} bytes, of which {} exist; {}", length,
                           bytes.size() - at, kCut));
    }
    at += length;
  }
}

/// A list of integers in a TIFF file's directory.
struct TiffList {
  std::uint64_t at = 0, count = 0;
  std::size_t size = 0;  ///< of an item: 2 or 4 bytes
};

/// The list of the directory entry at `entry`; empty unless it is of short or long integers.
TiffList tiff_list(const Numbers& numbers, std::uint64_t entry) {
  constexpr std::uint64_t kShort = 3, kLong = 4;
  const std::uint64_t type = numbers.at(entry + 2, 2);
  if (type != kShort && type != kLong) return {};
  TiffList list{entry + 8, numbers.at(entry + 4, 4), type == kShort ? 2u : 4u};
  if (list.count * list.size > 4) list.at = numbers.at(list.at, 4);
  return list;
}

/// Finds the strips or tiles of the first image.
void check_tiff(std::string_view bytes) {
  constexpr std::uint64_t kStrips = 273, kStripSizes = 279, kTiles = 324, kTileSizes = 325;
  const Numbers numbers(bytes, bytes.starts_with("MM"));
  const std::uint64_t directory = numbers.at(4, 4), entries = numbers.at(directory, 2);
  TiffList places, sizes;
  for (std::uint64_t i = 0; i < entries; ++i) {
    const std::uint64_t entry = directory + 2 + 12 * i, tag = numbers.at(entry, 2);
    if (tag == kStrips || tag == kTiles) places = tiff_list(numbers, entry);
    if (tag == kStripSizes || tag == kTileSizes) sizes = tiff_list(numbers, entry);
  }
  for (std::uint64_t i = 0; i < std::min(places.count, sizes.count); ++i) {
    const std::uint64_t begin = numbers.at(places.at + i * places.size, places.size);
    const std::uint64_t end = begin + numbers.at(sizes.at + i * sizes.size, sizes.size);
    if (end <= bytes.size()) continue;
    fail(bytes.size(),
         fmt::format("pixels from byte {} to byte {} should be here; {}", begin, end, kCut));
  }
}

/// Checks the last rows if rows are in order and of one image; tiles are not checked.
void check_exr(std::string_view bytes) {
  constexpr std::uint64_t kTiled = 0x200, kDeep = 0x800, kManyParts = 0x1000;
  const Numbers numbers(bytes, false);
  if (numbers.at(4, 4) & (kTiled | kDeep | kManyParts)) return;
  const auto text_at = [&](std::uint64_t at) {
    return bytes.substr(at, bytes.find('\0', at) - at);
  };
  std::uint64_t at = 8;
  while (numbers.at(at, 1) != 0) {
    const std::string_view name = text_at(at);
    const std::uint64_t type = at + name.size() + 1;
    numbers.at(type, 1);
    const std::uint64_t size = type + text_at(type).size() + 1, value = size + 4;
    const bool is_reversed = name == "lineOrder" && numbers.at(value, 1) != 0;
    if (is_reversed) return;
    at = value + numbers.at(size, 4);
  }
  // A table of offsets ends where the first of them points.
  const std::uint64_t first = numbers.at(at + 1, 8);
  if (first < at + 9) fail(at + 1, "the first rows are within the header; export it again");
  const std::uint64_t last = numbers.at(first - 8, 8), size = numbers.at(last + 4, 4);
  if (size <= bytes.size() - last - 8) return;
  fail(bytes.size(),
       fmt::format("rows from byte {} to byte {} should be here; {}", last, last + 8 + size, kCut));
}

void check_nothing(std::string_view) {}

/// TGA has no magic number: checks whether its header makes sense.
bool is_tga(std::string_view bytes) {
  constexpr std::string_view kTypes = "\x01\x02\x03\x09\x0A\x0B", kBits = "\x08\x0F\x10\x18\x20";
  return bytes.size() >= 18 && (unsigned char)(bytes[1]) <= 1 &&
         kTypes.find(bytes[2]) != kTypes.npos && kBits.find(bytes[16]) != kBits.npos;
}

/// A kind of image: the bytes of its files at byte `at`.
struct ImageKind {
  std::string_view magic;
  void (*check)(std::string_view bytes) = check_nothing;
  std::size_t at = 0;
};

using namespace std::string_view_literals;

constexpr ImageKind kKinds[]{
    {"\x89PNG\r\n\x1A\n", check_png},
    {"\xFF\xD8\xFF", check_jpeg},
    {"II*\0"sv, check_tiff},
    {"MM\0*"sv, check_tiff},
    {"II+\0"sv},  // BigTIFF
    {"MM\0+"sv},
    {"\x76\x2F\x31\x01", check_exr},
    {"#?"},  // Radiance
    {"BM"},
    {"GIF8"},
    {"WEBP", check_nothing, 8},
    {"8BPS"},  // Photoshop
    {"DDS "},
    {"\x01\xDA"},  // SGI
    {"SDPX"},
    {"XPDS"},
    {"\x80\x2A\x5F\xD7"},  // Cineon
    {"\xD7\x5F\x2A\x80"},
    {"\0\0\0\x0CjP"sv},  // JPEG 2000
    {"\xFF\x4F\xFF\x51"},
    {"ftyp", check_nothing, 4},  // HEIF and AVIF
    {"P1"},
    {"P2"},
    {"P3"},
    {"P4"},
    {"P5"},
    {"P6"},
    {"PF"},
    {"Pf"},  // PNM and PFM
};

}  // namespace

void check_image_bytes(std::string_view bytes) {
  const auto kind = std::ranges::find_if(kKinds, [&](const ImageKind& k) {
    return bytes.size() >= k.at && bytes.substr(k.at).starts_with(k.magic);
  });
  if (kind != std::end(kKinds)) return kind->check(bytes);
  if (is_tga(bytes)) return;
  fail(0, "not the beginning of a supported image; save it as PNG, JPEG, TIFF or OpenEXR");
}

}  // namespace lumaknot
