#include "study/measure/method_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/fields.h"

namespace lumaknot::measure {
namespace {

constexpr std::array<std::string_view, 4> kFormulaWords{"", ", collapsed", ", baked",
                                                        ", as in Table 1"};

/// "YIQ"
std::string space_word(Space space) {
  std::string word(kSpaceNames[std::size_t(space)]);
  for (char& c : word) {
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  }
  return word;
}

}  // namespace

std::string method_words(const Method& m) {
  const std::string grid =
      m.segments > 0 ? fmt::format("grid {} x {}", m.segments, m.sides) : "the scene's own mesh";
  return fmt::format("{}, light per {} in {}{}, {}, {} texture, {} sample{} per pixel{}", grid,
                     kFrequencyNames[std::size_t(m.rate)], space_word(m.space),
                     kFormulaWords[std::size_t(m.formula)], number_name(m.number),
                     filter_name(m.filter), m.samples, m.samples == 1 ? "" : "s",
                     m.culls ? ", back faces culled" : "");
}

const std::vector<MethodTerm>& method_legend() {
  static const std::vector<MethodTerm> kLegend{
      {"grid N x M",
       "the knot's mesh: N segments along it, M sides around the tube, two triangles "
       "for each pair"},
      {"the scene's own mesh", "a mesh file, as it is"},
      {"light per pixel, per vertex",
       "where the lighting is computed; between vertices it is interpolated"},
      {"in RGB, YIQ, ...",
       "the colour space that the light acts in: every channel of RGB, of other spaces the "
       "brightness alone"},
      {"collapsed", "the texture's colour plus the change of its brightness (linear spaces)"},
      {"baked", "the texture holds the space's coordinates (linear spaces)"},
      {"as in Table 1", "the paper's listing: clamps, -0.1, and the normal as interpolated"},
      {"half, float, double",
       "the numbers that light and colour are computed with; half is emulated, so that its time "
       "says "
       "nothing of hardware"},
      {"bilinear, trilinear texture", "texels are interpolated; trilinear: between mipmaps too"},
      {"N samples per pixel",
       "one: at the pixel's centre; more: float shades once per triangle and pixel and takes N "
       "samples of coverage, half and double shade each"},
      {"back faces culled", "triangles that are seen from behind are not drawn"}};
  return kLegend;
}

validate::PageData method_legend_rows() {
  return validate::page_list(method_legend(), [](const MethodTerm& term) {
    validate::PageData row;
    row.set("word", std::string(term.word));
    row.set("meaning", std::string(term.meaning));
    return row;
  });
}

}  // namespace lumaknot::measure
