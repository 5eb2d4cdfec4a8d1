/// Shared by the exporters' tests: a folder to write into, small meshes and scenes.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "exporters/package.h"
#include "meshgen/knot_mesh.h"
#include "scene/presets.h"
#include "system/atomic_file.h"
#include "tests/scene/error_of.h"

namespace lumaknot::testing {

/// A new folder, removed with its contents.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lumaknot-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

  /// Writes `text` and returns its path.
  std::filesystem::path file(std::string_view name, std::string_view text) const {
    write_file(path_ / name, text, "--test");
    return path_ / name;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_at(const std::filesystem::path& path) { return read_file(path, "test"); }

inline KnotSpec small_knot() {
  KnotSpec knot;
  knot.segments = 24;
  knot.sides = 6;
  knot.repeat_u = 3;
  return knot;
}

/// A tetrahedron, one vertex per corner, its numbers with few digits in float32.
inline TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
  mesh.normals = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}, {0.25, 1e-7}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// A texture whose values are multiples of 1/255 and of nothing coarser.
inline TextureImage small_texture() {
  TextureImage image(5, 3);
  for (int i = 0; i < 15; ++i) {
    image.pixels[std::size_t(i)] = {float(17 * i) / 255, float(255 - 13 * i) / 255,
                                    float((101 * i) % 256) / 255};
  }
  return image;
}

inline Scene small_scene(Texture texture = small_texture()) {
  return {knot_mesh(small_knot()), std::move(texture), builtin_scene("figure2")->view};
}

inline Material material(std::string_view name) { return *with_formula(Material{}, name); }

/// The lines of `text` that begin with `prefix`.
inline int lines_with(const std::string& text, std::string_view prefix) {
  std::istringstream stream(text);
  int count = 0;
  for (std::string line; std::getline(stream, line);) count += line.starts_with(prefix);
  return count;
}

inline int occurrences(std::string_view text, std::string_view part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

inline const PackedFile* find(const Package& package, std::string_view name) {
  for (const PackedFile& file : package) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

inline std::vector<std::string> names(const Package& package) {
  std::vector<std::string> names;
  for (const PackedFile& file : package) names.push_back(file.name);
  return names;
}

}  // namespace lumaknot::testing
