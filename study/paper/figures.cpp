#include "study/paper/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scene/presets.h"
#include "system/known.h"
#include "validate/report/forms.h"
#include "validate/run.h"

namespace lumaknot::paper {
namespace {

const std::vector<std::string> kRenderers{"cycles", "povray"};

/// "povray" for "POV-Ray".
std::string file_word(std::string_view name) {
  std::string word;
  for (const unsigned char c : name) {
    if (std::isalnum(c)) word += char(std::tolower(c));
  }
  return word;
}

/// The pictures of one light, all from one process of each renderer.
std::vector<Shot> front_shots(const PaperScenes& scenes) {
  const Material& front = scenes.front.view.material;
  const Material specular = transferred(scenes.specular, scenes.front);
  return {{"front-phong", Stage::kFinal, known(with_formula(front, "phong"))},
          {"front-yiq", Stage::kFinal, known(with_formula(front, "yiq-eq6"))},
          {"front-table1", Stage::kFinal, known(with_formula(front, "yiq-table1"))},
          {"specular-phong", Stage::kFinal, known(with_formula(specular, "phong"))},
          {"specular-yiq", Stage::kFinal, known(with_formula(specular, "yiq-eq6"))}};
}

std::vector<Shot> back_shots(const PaperScenes& scenes) {
  const Material& back = scenes.back.view.material;
  return {{"back-phong", Stage::kFinal, known(with_formula(back, "phong"))},
          {"back-yiq", Stage::kFinal, known(with_formula(back, "yiq-eq6"))}};
}

double agreeing_share(const validate::Comparison& c) {
  return c.covered ? 1 - double(c.outliers + c.coverage_differs) / double(c.covered) : 0;
}

FigureImage their_image(const std::string& shot, const std::string& renderer,
                        const validate::Judged& judged) {
  FigureImage image{.renderer = renderer,
                    .file = {},
                    .png = judged.pictures.display,
                    .outcome = std::string(validate::outcome(judged)),
                    .why = judged.drawn.why,
                    .note = judged.drawn.note};
  if (judged.drawn.status != validate::RenderedShot::Status::kDrawn) return image;
  image.file = figure_file(shot, renderer);
  image.mean = judged.comparison.mean;
  image.agree = agreeing_share(judged.comparison);
  return image;
}

/// The shot's picture by all renderers.
FigurePicture picture_of(const validate::Validation& validation, std::size_t shot) {
  const std::string& name = validation.shots[shot].name;
  FigurePicture picture{name, {}, {}};
  const std::string& own = validation.own.renderer;
  picture.images.push_back({.renderer = own,
                            .file = figure_file(name, own),
                            .png = validation.own_pictures[shot].display,
                            .outcome = {},
                            .why = {},
                            .note = {}});
  for (const validate::RendererResult& result : validation.results) {
    picture.images.push_back(their_image(name, result.rendering.renderer, result.shots[shot]));
  }
  return picture;
}

FigureRenderer renderer_of(const validate::RendererResult& result) {
  const validate::Rendering& r = result.rendering;
  return {.name = r.renderer,
          .version = r.version,
          .seconds = r.seconds,
          .missing = result.drew_any() ? "" : result.shots.front().drawn.why};
}

/// A renderer's results for both lights.
FigureRenderer joined(const FigureRenderer& a, const FigureRenderer& b) {
  const bool drew = a.missing.empty() || b.missing.empty();
  return {.name = a.name,
          .version = a.version.empty() ? b.version : a.version,
          .seconds = a.seconds + b.seconds,
          .missing = drew ? "" : a.missing};
}

}  // namespace

std::string figure_file(std::string_view picture, std::string_view renderer) {
  return fmt::format("images/{}-{}.png", picture, file_word(renderer));
}

bool LightPictures::complete() const {
  const auto is_drawn = [](const FigureImage& image) { return !image.file.empty(); };
  return std::ranges::all_of(
      pictures, [&](const FigurePicture& p) { return std::ranges::all_of(p.images, is_drawn); });
}

LightPictures draw_light(const PaperScenes& scenes, FigureLight light,
                         const validate::Programs& programs,
                         const std::function<void()>& on_message) {
  const bool front = light == FigureLight::kFront;
  const validate::ValidationJob job{.scene = front ? scenes.front : scenes.back,
                                    .finals = front ? front_shots(scenes) : back_shots(scenes),
                                    .renderers = kRenderers,
                                    .programs = programs,
                                    .keeps_displays = true};
  const validate::Validation validation = validate::validate(job, [&](const std::string&) {
    if (on_message) on_message();
  });
  LightPictures result;
  for (std::size_t i = 0; i < validation.shots.size(); ++i) {
    if (validation.shots[i].stage != Stage::kFinal) continue;
    result.pictures.push_back(picture_of(validation, i));
  }
  for (const validate::RendererResult& of_one : validation.results) {
    result.renderers.push_back(renderer_of(of_one));
  }
  return result;
}

Figures figures_of(const LightPictures& front, const LightPictures& back) {
  Figures figures;
  const auto add = [](std::vector<FigurePicture>& figure, const LightPictures& light,
                      std::string_view name, std::string caption) {
    figure.push_back(*std::ranges::find(light.pictures, name, &FigurePicture::name));
    figure.back().caption = std::move(caption);
  };
  add(figures.figure1, front, "front-phong", "Phong, light in front");
  add(figures.figure1, front, "front-yiq", "YIQ, light in front");
  add(figures.figure1, back, "back-phong", "Phong, light at the back");
  add(figures.figure1, back, "back-yiq", "YIQ, light at the back");
  add(figures.figure1, front, "specular-phong", "Phong, specular reflection only");
  add(figures.figure1, front, "specular-yiq", "YIQ, specular reflection only");
  add(figures.figure2, front, "front-phong", "Classical lighting, eq. 3");
  add(figures.figure2, front, "front-yiq", "YIQ, eq. 6 to 8");
  add(figures.figure2, front, "front-table1", "YIQ as Table 1 lists it");
  for (std::size_t i = 0; i < front.renderers.size(); ++i) {
    figures.renderers.push_back(joined(front.renderers[i], back.renderers[i]));
  }
  return figures;
}

}  // namespace lumaknot::paper
