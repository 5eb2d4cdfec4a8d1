#include "exporters/obj/scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/image/file.h"
#include "exporters/obj/format.h"
#include "math/number.h"
#include "system/atomic_file.h"

namespace lumaknot::obj {
namespace {

constexpr double kMaxShininess = 1000;  // of Ns, as defined by MTL

std::string color_line(std::string_view key, const Vec3d& color) {
  const auto limited = [](double c) { return std::clamp(c, 0.0, 1.0); };
  return fmt::format("{} {} {} {}\n", key, limited(color.x), limited(color.y), limited(color.z));
}

std::string material_text(const Scene& scene, std::string_view texture_file) {
  const Material& material = scene.view.material;
  Vec3d diffuse = material.diffuse_color * material.diffuse;
  if (const auto* color = std::get_if<Vec3d>(&scene.texture)) diffuse = modulate(diffuse, *color);
  std::string text = "# Made by lumaknot\nnewmtl lumaknot\n";
  text += color_line("Kd", diffuse);
  text += color_line("Ks", material.specular_color * material.specular);
  text +=
      fmt::format("Ns {}\nillum 2\n", std::min(material.parameters["shininess"], kMaxShininess));
  if (!texture_file.empty()) text += fmt::format("map_Kd {}\n", texture_file);
  return text;
}

}  // namespace

Package obj_materials(const Scene& scene, const std::string& name) {
  std::string plain = name;
  std::ranges::replace_if(plain, [](char c) { return c == ' ' || c == '#'; }, '_');
  Package package;
  if (const auto* image = std::get_if<TextureImage>(&scene.texture)) {
    package.push_back({plain + ".texture.png", texture_png(*image)});
  }
  const std::string texture_file = package.empty() ? "" : package.front().name;
  package.push_back({plain + ".mtl", material_text(scene, texture_file)});
  return package;
}

std::vector<std::string> write_obj_scene(const std::filesystem::path& path,
                                         const TriangleMesh& mesh, const Package& materials,
                                         std::string_view flag) {
  write_package(path.parent_path(), materials, flag);
  const auto write_both = [&](std::ostream& stream) {
    stream << fmt::format("mtllib {}\nusemtl lumaknot\n", materials.back().name);
    write(stream, mesh, {});
  };
  write_file(path, write_both, flag);
  std::vector<std::string> names;
  for (const PackedFile& file : materials) names.push_back(file.name);
  names.push_back(path.filename().string());
  return names;
}

}  // namespace lumaknot::obj
