// Mesh files through Assimp, whose readers keep a normal and a texture coordinate a corner.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <map>

#include "exporters/mesh_file.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

struct Vertex {
  Vec3d position, normal;
  Vec2d uv;
};

/// Gathers triangles and gives equal vertices one index.
class Gatherer {
 public:
  void add(const std::array<Vertex, 3>& corners) {
    mesh_.triangles.push_back({index(corners[0]), index(corners[1]), index(corners[2])});
  }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  using Key = std::array<double, 8>;

  std::uint32_t index(const Vertex& v) {
    const Key key{v.position.x, v.position.y, v.position.z, v.normal.x,
                  v.normal.y,   v.normal.z,   v.uv.u,       v.uv.v};
    const auto [found, is_new] = known_.try_emplace(key, std::uint32_t(mesh_.positions.size()));
    if (is_new) {
      mesh_.positions.push_back(v.position);
      mesh_.normals.push_back(v.normal);
      mesh_.uvs.push_back(v.uv);
    }
    return found->second;
  }

  TriangleMesh mesh_;
  std::map<Key, std::uint32_t> known_;
};

Vec3d to_vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

Vertex vertex_of(const aiMesh& part, unsigned index) {
  Vertex v{to_vec(part.mVertices[index]), to_vec(part.mNormals[index]), {}};
  const double norm = length(v.normal);
  if (norm > 0) v.normal = v.normal / norm;
  if (part.HasTextureCoords(0)) {
    v.uv = {part.mTextureCoords[0][index].x, part.mTextureCoords[0][index].y};
  }
  return v;
}

bool is_finite(const Vertex& v) {
  return lumaknot::is_finite(v.position) && lumaknot::is_finite(v.normal) &&
         std::isfinite(v.uv.u) && std::isfinite(v.uv.v);
}

void gather(const aiMesh& part, std::string_view label, Gatherer& gatherer) {
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const unsigned* corner = part.mFaces[f].mIndices;
    if (std::max({corner[0], corner[1], corner[2]}) >= part.mNumVertices) {
      throw Error(fmt::format("{} has a face with a vertex that it does not hold", label));
    }
    const std::array<Vertex, 3> corners{vertex_of(part, corner[0]), vertex_of(part, corner[1]),
                                        vertex_of(part, corner[2])};
    for (const Vertex& v : corners) {
      if (is_finite(v)) continue;
      throw Error(fmt::format("{} holds numbers that are not finite; export it again", label));
    }
    gatherer.add(corners);
  }
}

/// Assimp guesses formats from contents, and reads a PLY header without an end for ever.
void check_readable(const std::filesystem::path& path, std::string_view label) {
  constexpr std::array kExtensions{".obj", ".ply", ".off", ".stl"};
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return char(std::tolower(c)); });
  if (std::ranges::find(kExtensions, extension) == kExtensions.end()) {
    throw Error(fmt::format("{} {} must end in .obj, .ply, .off or .stl", label, path.string()));
  }
  const std::string text = read_file(path, label);
  if (extension == ".ply" && text.find("end_header") == text.npos) {
    throw Error(fmt::format("{} {} has no end_header: it is no PLY file, or cut short", label,
                            path.string()));
  }
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path, bool needs_uvs, std::string_view label) {
  check_readable(path, label);
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* file = importer.ReadFile(
      path.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                         aiProcess_ValidateDataStructure | aiProcess_PreTransformVertices);
  if (!file || file->mNumMeshes == 0) {
    throw Error(fmt::format("{} {} can't be read as a mesh: {}; known: .obj .ply .off .stl", label,
                            path.string(),
                            file ? "it holds no triangles" : importer.GetErrorString()));
  }
  Gatherer gatherer;
  for (unsigned m = 0; m < file->mNumMeshes; ++m) {
    const aiMesh& part = *file->mMeshes[m];
    if (needs_uvs && !part.HasTextureCoords(0)) {
      throw Error(
          fmt::format("{} {} has no texture coordinates; give it some, or set texture to a "
                      "plain {{\"color\": [r, g, b]}}",
                      label, path.string()));
    }
    gather(part, fmt::format("{} {}", label, path.string()), gatherer);
  }
  return gatherer.take();
}

}  // namespace lumaknot
