#include "study/measure/method.h"

#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include <array>
#include <cmath>
#include <string_view>

#include "render/fast/renderer.h"
#include "render/fast/sample_pattern.h"
#include "render/reference.h"
#include "scene/fields.h"
#include "system/error.h"

namespace lumaknot::measure {
namespace {

constexpr std::array<std::string_view, 4> kFormulaEnds{"", "-collapsed", "-baked", "-table1"};
constexpr std::array<std::string_view, 3> kNumberNames{"half", "float", "double"};
constexpr std::array<std::string_view, 2> kFilterNames{"bilinear", "trilinear"};

int root_of(int samples) { return int(std::lround(std::sqrt(samples))); }

}  // namespace

std::string_view number_name(Number number) { return kNumberNames[std::size_t(number)]; }

std::string_view filter_name(Filter filter) { return kFilterNames[std::size_t(filter)]; }

Method with_grid(Method method, const GridSize& grid) {
  method.segments = grid.segments;
  method.sides = grid.sides;
  return method;
}

std::string method_name(const Method& m) {
  const std::string grid = m.segments > 0 ? fmt::format("{}x{}", m.segments, m.sides) : "mesh";
  return fmt::format("{} {} {}{} {} {} {}x{}", grid, kFrequencyNames[std::size_t(m.rate)],
                     kSpaceNames[std::size_t(m.space)], kFormulaEnds[std::size_t(m.formula)],
                     number_name(m.number), filter_name(m.filter), m.samples,
                     m.culls ? " culled" : "");
}

std::string method_shortfall(const Method& m) {
  const bool is_form = m.formula == Formula::kCollapsed || m.formula == Formula::kBaked;
  if (is_form && !is_linear(m.space)) return "only linear spaces are collapsed or baked";
  if (m.formula == Formula::kTable1 && m.space == Space::kRgb) {
    return "Table 1 needs a space of brightness";
  }
  if (m.number == Number::kFloat) {
    return fast::sample_pattern(m.samples).empty() ? "float has 1, 2, 4, 6, 8 or 16 samples" : "";
  }
  if (m.filter == Filter::kTrilinear) return "half and double have no mipmaps";
  if (m.culls) return "half and double draw both sides";
  const int root = root_of(m.samples);
  return m.samples < 1 || root * root != m.samples ? "half and double have n x n samples" : "";
}

Material true_material(const Material& material, Space space) {
  Material exact = material;
  exact.space = space;
  exact.form = Form::kMatrices;
  exact.normal = NormalUse::kUnit;
  exact.rate = ShadingFrequency::kPixel;
  if (space == Space::kRgb) exact.luma_offset = 0;  // there is no luma
  return exact;
}

Material method_material(const Method& method, const Material& material) {
  Material result = true_material(material, method.space);
  result.rate = method.rate;
  if (method.formula == Formula::kCollapsed) result.form = Form::kCollapsed;
  if (method.formula == Formula::kBaked) result.form = Form::kBaked;
  if (method.formula == Formula::kTable1) {
    result.clamp = Clamp::kTable1;
    result.normal = NormalUse::kInterpolated;
    result.luma_offset = -0.1;
  }
  return result;
}

MeshSpec method_mesh(const Method& method, const MeshSpec& mesh) {
  MeshSpec result = mesh;
  if (auto* knot = std::get_if<KnotSpec>(&result); knot && method.segments > 0) {
    knot->segments = method.segments;
    knot->sides = method.sides;
  }
  return result;
}

class MethodRenderer::Frames {
 public:
  Frames(const Method& method, Scene scene, int threads)
      : number_(method.number), scene_(std::move(scene)) {
    if (threads > 0) arena_.initialize(threads);
    if (const std::string why = method_shortfall(method); !why.empty()) {
      throw Error(fmt::format("{} can't be drawn: {}", method_name(method), why));
    }
    scene_.view.material = method_material(method, scene_.view.material);
    const bool fast = number_ == Number::kFloat;
    scene_.view.image.samples = fast ? 1 : root_of(method.samples);
    if (!fast) return;
    fast::Options options;
    options.samples = method.samples;
    options.filter = method.filter;
    options.cull_back_faces = method.culls;
    options.threads = threads;
    fast_ = std::make_unique<fast::Renderer>(scene_, options);
  }

  void draw() {
    if (fast_) {
      fast_->draw(bytes_);
    } else {
      image();
    }
  }

  Image image() {
    if (!fast_) {
      return arena_.execute(
          [&] { return number_ == Number::kHalf ? render_in_half(scene_) : render(scene_); });
    }
    Image image;
    fast_->draw(image);
    return image;
  }

 private:
  Number number_;
  Scene scene_;
  oneapi::tbb::task_arena arena_;
  std::unique_ptr<fast::Renderer> fast_;
  Grid<fast::Rgba8> bytes_;
};

MethodRenderer::MethodRenderer(const Method& method, Scene scene, int threads)
    : frames_(std::make_unique<Frames>(method, std::move(scene), threads)) {}

MethodRenderer::~MethodRenderer() = default;

void MethodRenderer::draw() { frames_->draw(); }
Image MethodRenderer::image() { return frames_->image(); }

}  // namespace lumaknot::measure
