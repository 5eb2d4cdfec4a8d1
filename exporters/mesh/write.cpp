// The table of mesh formats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "exporters/gltf/scene.h"
#include "exporters/mesh/file.h"
#include "exporters/mesh/writers.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot {
namespace {

using Write = void (*)(const std::filesystem::path& path, const TriangleMesh& mesh,
                       const MeshFileOptions& options, std::string_view flag);

/// Writes a file that contains all of the mesh.
template <void (*write)(std::ostream&, const TriangleMesh&, const MeshFileOptions&)>
void write_whole(const std::filesystem::path& path, const TriangleMesh& mesh,
                 const MeshFileOptions& options, std::string_view flag) {
  write_file(path, [&](std::ostream& stream) { write(stream, mesh, options); }, flag);
}

void write_glb_stream(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions&) {
  write_glb(stream, mesh);
}

/// NAME.bin first: the file that refers to it is the one to open.
void write_gltf_pair(const std::filesystem::path& path, const TriangleMesh& mesh,
                     const MeshFileOptions&, std::string_view flag) {
  check_package_name(path, flag);
  std::filesystem::path binary = path;
  binary.replace_extension(".bin");
  std::ostringstream json;
  write_file(
      binary,
      [&](std::ostream& stream) { write_gltf(json, stream, mesh, binary.filename().string()); },
      flag);
  write_file(path, json.str(), flag);
}

struct WritableFormat {
  std::string_view extension;
  Write write;
  bool has_text;              ///< always, or as MeshFileOptions::ascii
  bool has_quads;             ///< as MeshFileOptions::quads
  bool has_tangents = false;  ///< as MeshFileOptions::tangents
};

constexpr WritableFormat kWritableFormats[] = {
    {".obj", write_whole<write_obj>, true, true},
    {".ply", write_whole<write_ply>, true, true},
    {".stl", write_whole<write_stl>, true, false},
    {".off", write_whole<write_off>, true, true},
    {".om", write_whole<write_om>, false, false},
    {".glb", write_whole<write_glb_stream>, false, false, true},
    {".gltf", write_gltf_pair, false, false, true},
    {".inc", write_whole<write_pov_include>, true, false},
};

/// ".obj, .ply or .off": the extensions of the formats that `has` selects.
template <class Has>
std::string extensions(Has has) {
  std::vector<std::string_view> names;
  for (const WritableFormat& format : kWritableFormats) {
    if (std::invoke(has, format)) names.push_back(format.extension);
  }
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

const WritableFormat& writable_format(const std::filesystem::path& path, std::string_view flag) {
  const std::string extension = path.extension().string();
  for (const WritableFormat& format : kWritableFormats) {
    if (extension == format.extension) return format;
  }
  throw Error(fmt::format("{} {} must end in {}", flag, path.string(),
                          extensions([](const WritableFormat&) { return true; })));
}

bool fits(double value) { return std::abs(value) <= std::numeric_limits<float>::max(); }

/// Numbers beyond float32 would be written as infinite.
void check_fits(const TriangleMesh& mesh, std::string_view flag) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d& p = mesh.positions[i];
    const Vec2d& uv = mesh.uvs[i];
    if (fits(p.x) && fits(p.y) && fits(p.z) && fits(uv.u) && fits(uv.v)) continue;
    throw Error(
        fmt::format("{}: vertex {} of the mesh does not fit in float32: position ({}, {}, {}), "
                    "texture coordinate ({}, {}); make the mesh smaller",
                    flag, i, p.x, p.y, p.z, uv.u, uv.v));
  }
}

}  // namespace

void check_mesh_output(const std::filesystem::path& path, const MeshFileOptions& options,
                       std::string_view flag) {
  const WritableFormat& format = writable_format(path, flag);
  if (options.ascii && !format.has_text) {
    throw Error(fmt::format("{} {} can't be text: its format is binary only; end it in {}", flag,
                            path.string(), extensions(&WritableFormat::has_text)));
  }
  if (options.quads && !format.has_quads) {
    throw Error(fmt::format("{} {} can't hold quads: its format has triangles only; end it in {}",
                            flag, path.string(), extensions(&WritableFormat::has_quads)));
  }
  if (options.tangents && !format.has_tangents) {
    throw Error(fmt::format("{} {} can't hold tangents; end it in {}", flag, path.string(),
                            extensions(&WritableFormat::has_tangents)));
  }
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& options, std::string_view flag) {
  check_mesh_output(path, options, flag);
  if (options.quads && !mesh.quads) {
    throw Error(
        fmt::format("{} {} can't hold quads: the mesh has triangles only; don't ask for quads",
                    flag, path.string()));
  }
  check_fits(mesh, flag);
  writable_format(path, flag).write(path, mesh, options, flag);
}

}  // namespace lumaknot
