#include "validate/renderers/external.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/image/file.h"

namespace lumaknot::validate {

std::vector<RenderedShot> undrawn(std::size_t shots, RenderedShot::Status status,
                                  const std::string& why) {
  return std::vector<RenderedShot>(
      shots, RenderedShot{.status = status, .why = why, .image = {}, .note = {}, .instead = {}});
}

RenderedShot checked_image(const std::function<Image()>& read) {
  RenderedShot drawn;
  try {
    drawn.image = read();
  } catch (const std::runtime_error& e) {
    return undrawn(1, RenderedShot::Status::kFailed, e.what()).front();
  }
  const bool shows = std::ranges::any_of(
      drawn.image.pixels, [](const RgbaPixel& p) { return p.coverage > 0 || p.color != Rgb{}; });
  if (!shows) return undrawn(1, RenderedShot::Status::kFailed, "the image is blank").front();
  const bool finite = std::ranges::all_of(drawn.image.pixels, [](const RgbaPixel& p) {
    return is_finite(to_vec(p.color)) && std::isfinite(p.coverage);
  });
  if (!finite) {
    return undrawn(1, RenderedShot::Status::kFailed, "the image holds numbers that are not finite")
        .front();
  }
  drawn.status = RenderedShot::Status::kDrawn;
  return drawn;
}

RenderedShot drawn_image(const std::filesystem::path& path, const View& view) {
  return checked_image([&] { return read_image(path, view.image.width, view.image.height); });
}

std::string line_with(std::string_view text, std::string_view prefix) {
  for (const std::string_view line : split(text, '\n')) {
    if (line.starts_with(prefix)) return std::string(line);
  }
  return {};
}

std::string bad_end(const ProcessResult& ended) {
  if (ended.timed_out) return fmt::format("killed at its time limit after {:.0f} s", ended.seconds);
  if (ended.exit_code == 0) return {};
  std::string last;
  for (const std::string_view line : split(ended.log, '\n')) {
    if (line.find_first_not_of(" \r\t") != std::string_view::npos) last = line;
  }
  return fmt::format("ended with exit code {}: {}", ended.exit_code, last);
}

std::string version_of(const std::filesystem::path& path, const std::string& argument,
                       std::string_view prefix) {
  try {
    const PrivateFolder folder;
    const ProcessResult ended =
        run({{path.string(), argument}, folder.path(), {}}, std::chrono::seconds(30));
    return line_with(ended.log, prefix);
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace lumaknot::validate
