#include "study/paper/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scene/presets.h"
#include "validate/report.h"
#include "validate/validate.h"

namespace lumaknot {
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

std::string file_of(std::string_view picture, std::string_view renderer) {
  return fmt::format("images/{}-{}.png", picture, file_word(renderer));
}

/// The pictures of one light, all from one process of each renderer.
std::vector<Shot> front_shots(const PaperScenes& scenes) {
  const Material& front = scenes.front.view.material;
  const Material specular = transferred(scenes.specular, scenes.front);
  return {{"front-phong", Stage::kFinal, *with_formula(front, "phong")},
          {"front-yiq", Stage::kFinal, *with_formula(front, "yiq-eq6")},
          {"front-table1", Stage::kFinal, *with_formula(front, "yiq-table1")},
          {"specular-phong", Stage::kFinal, *with_formula(specular, "phong")},
          {"specular-yiq", Stage::kFinal, *with_formula(specular, "yiq-eq6")}};
}

std::vector<Shot> back_shots(const PaperScenes& scenes) {
  const Material& back = scenes.back.view.material;
  return {{"back-phong", Stage::kFinal, *with_formula(back, "phong")},
          {"back-yiq", Stage::kFinal, *with_formula(back, "yiq-eq6")}};
}

double agreeing_share(const Comparison& c) {
  return c.covered ? 1 - double(c.outliers + c.coverage_differs) / double(c.covered) : 0;
}

FigureImage their_image(const std::string& shot, const std::string& renderer,
                        const Judged& judged) {
  FigureImage image{.renderer = renderer,
                    .file = {},
                    .png = judged.pictures.theirs,
                    .outcome = std::string(outcome(judged)),
                    .why = judged.drawn.why,
                    .note = judged.drawn.note};
  if (judged.drawn.status != Drawn::Status::kDrawn) return image;
  image.file = file_of(shot, renderer);
  image.mean = judged.comparison.mean;
  image.agree = agreeing_share(judged.comparison);
  return image;
}

/// The shot's picture by all renderers.
FigurePicture picture_of(const Validation& validation, std::size_t shot) {
  const std::string& name = validation.shots[shot].name;
  FigurePicture picture{name, {}, {}};
  const std::string& own = validation.own.renderer;
  picture.images.push_back({.renderer = own,
                            .file = file_of(name, own),
                            .png = validation.own_pictures[shot],
                            .outcome = {},
                            .why = {},
                            .note = {}});
  for (const Judgement& judgement : validation.judgements) {
    picture.images.push_back(
        their_image(name, judgement.rendering.renderer, judgement.shots[shot]));
  }
  return picture;
}

void add_renderers(const Validation& validation, std::vector<FigureRenderer>& all) {
  for (const Judgement& judgement : validation.judgements) {
    const Rendering& r = judgement.rendering;
    auto known = std::ranges::find(all, r.renderer, &FigureRenderer::name);
    if (known == all.end()) known = all.insert(all.end(), {r.renderer, {}, 0, {}});
    if (known->version.empty()) known->version = r.version;
    known->seconds += r.seconds;
    if (!judgement.drew_any()) known->missing = judgement.shots.front().drawn.why;
  }
}

FigurePicture captioned(const std::vector<FigurePicture>& all, std::string_view name,
                        std::string caption) {
  FigurePicture picture = *std::ranges::find(all, name, &FigurePicture::name);
  picture.caption = std::move(caption);
  return picture;
}

}  // namespace

Figures draw_figures(const PaperScenes& scenes, const Programs& programs,
                     const Progress& progress) {
  Figures figures;
  std::vector<FigurePicture> all;
  const double steps = 2 * double(kRenderers.size());
  double done = 0;
  const auto draw = [&](const Scene& scene, std::vector<Shot> finals) {
    const ValidationJob job{scene, std::move(finals), kRenderers, programs};
    const Validation validation = validate(job, [&](const std::string&) {
      if (progress) progress(++done / steps);
    });
    for (std::size_t i = 0; i < validation.shots.size(); ++i) {
      if (validation.shots[i].stage == Stage::kFinal) all.push_back(picture_of(validation, i));
    }
    add_renderers(validation, figures.renderers);
  };
  draw(scenes.front, front_shots(scenes));
  draw(scenes.back, back_shots(scenes));
  figures.figure1 = {captioned(all, "front-phong", "Phong, light in front"),
                     captioned(all, "front-yiq", "YIQ, light in front"),
                     captioned(all, "back-phong", "Phong, light at the back"),
                     captioned(all, "back-yiq", "YIQ, light at the back"),
                     captioned(all, "specular-phong", "Phong, specular reflection only"),
                     captioned(all, "specular-yiq", "YIQ, specular reflection only")};
  figures.figure2 = {captioned(all, "front-phong", "Classical lighting, eq. 3"),
                     captioned(all, "front-yiq", "YIQ, eq. 6 to 8"),
                     captioned(all, "front-table1", "YIQ as Table 1 lists it")};
  return figures;
}

}  // namespace lumaknot
