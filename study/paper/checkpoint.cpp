#include "study/paper/checkpoint.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "study/measure/checkpoint.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::paper {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kFlag = "--output";

fs::path file_of(const fs::path& folder, FigureLight light) {
  return folder / "images" / (light == FigureLight::kFront ? "front.json" : "back.json");
}

measure::Checkpoint checkpoint_of(const fs::path& folder, FigureLight light,
                                  const std::string& key) {
  return {file_of(folder, light), {{"key", key}}};
}

Json kept_image_json(const FigureImage& i) {
  return {{"renderer", i.renderer}, {"file", i.file}, {"outcome", i.outcome}, {"why", i.why},
          {"note", i.note},         {"mean", i.mean}, {"agree", i.agree}};
}

FigureImage image_from(const Json& json, const fs::path& folder) {
  FigureImage image{.renderer = json.at("renderer"),
                    .file = json.at("file"),
                    .png = {},
                    .outcome = json.at("outcome"),
                    .why = json.at("why"),
                    .note = json.at("note"),
                    .mean = json.at("mean"),
                    .agree = json.at("agree")};
  if (!image.file.empty()) image.png = read_file(folder / image.file, image.file);
  return image;
}

Json kept_renderer_json(const FigureRenderer& r) {
  return {{"name", r.name}, {"version", r.version}, {"seconds", r.seconds}, {"missing", r.missing}};
}

LightPictures light_from(const Json& json, const fs::path& folder) {
  LightPictures light;
  for (const Json& picture : json.at("pictures")) {
    light.pictures.push_back({picture.at("name"), {}, {}});
    for (const Json& image : picture.at("images")) {
      light.pictures.back().images.push_back(image_from(image, folder));
    }
  }
  for (const Json& r : json.at("renderers")) {
    light.renderers.push_back({.name = r.at("name"),
                               .version = r.at("version"),
                               .seconds = r.at("seconds"),
                               .missing = r.at("missing")});
  }
  return light;
}

}  // namespace

void keep_light(const LightPictures& light, const fs::path& folder, FigureLight which,
                const std::string& key) {
  fs::create_directories(folder / "images");
  Json json{{"pictures", Json::array()}, {"renderers", Json::array()}};
  for (const FigurePicture& picture : light.pictures) {
    Json images = Json::array();
    for (const FigureImage& image : picture.images) {
      if (image.file.empty()) {  // removes what an earlier run drew
        fs::remove(folder / figure_file(picture.name, image.renderer));
      } else {
        write_file(folder / image.file, image.png, kFlag);
      }
      images.push_back(kept_image_json(image));
    }
    json["pictures"].push_back({{"name", picture.name}, {"images", images}});
  }
  for (const FigureRenderer& r : light.renderers)
    json["renderers"].push_back(kept_renderer_json(r));
  checkpoint_of(folder, which, key).save(json);
}

std::optional<LightPictures> kept_light(const fs::path& folder, FigureLight which,
                                        const std::string& key) {
  std::optional<LightPictures> light;
  try {
    checkpoint_of(folder, which, key).load([&](const Json& json) {
      light = light_from(json, folder);
    });
  } catch (const Error&) {  // a file that can't be read is drawn again
    return std::nullopt;
  }
  return light && light->complete() ? light : std::nullopt;
}

void forget_lights(const fs::path& folder) {
  std::error_code ignored;
  for (const FigureLight light : {FigureLight::kFront, FigureLight::kBack}) {
    fs::remove(file_of(folder, light), ignored);
  }
}

int checkpointed_lights(const fs::path& folder, const std::string& key) {
  return int(kept_light(folder, FigureLight::kFront, key).has_value()) +
         int(kept_light(folder, FigureLight::kBack, key).has_value());
}

}  // namespace lumaknot::paper
