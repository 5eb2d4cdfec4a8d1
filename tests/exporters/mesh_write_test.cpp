#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/mesh_file.h"
#include "tests/exporters/exporters_testing.h"

namespace lumaknot {
namespace {

using testing::bytes_at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TemporaryFolder;

TriangleMesh small_mesh() { return knot_mesh(testing::small_knot()); }

/// Triangle by triangle, corner by corner; indices may differ.
void expect_same_surface(const TriangleMesh& read, const TriangleMesh& written) {
  ASSERT_EQ(read.triangles.size(), written.triangles.size());
  ASSERT_EQ(read.positions.size(), written.positions.size());
  for (std::size_t t = 0; t < read.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = read.triangles[t][c], b = written.triangles[t][c];
      // float32 keeps 24 bits: half a unit of 2^-23 for components below 2, below 4 for uvs; a
      // normal is made unit again.
      EXPECT_LT(length(read.positions[a] - written.positions[b]), 3e-7);
      EXPECT_LT(length(read.normals[a] - written.normals[b]), 3e-7);
      EXPECT_NEAR(read.uvs[a].u, written.uvs[b].u, 3e-7);
      EXPECT_NEAR(read.uvs[a].v, written.uvs[b].v, 3e-7);
    }
  }
}

class MeshFormat : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, MeshFormat, ::testing::Values(".obj", ".ply"),
                         [](const auto& format) { return std::string(format.param + 1); });

TEST_P(MeshFormat, mesh_read_back_is_the_mesh_in_float32) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam());
  const TriangleMesh mesh = small_mesh();
  write_mesh(path, mesh, {}, "--output");
  expect_same_surface(read_mesh(path, true, "mesh.file"), mesh);
}

TEST_P(MeshFormat, positions_survive_as_the_nearest_float32) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam());
  const TriangleMesh mesh = small_mesh();
  write_mesh(path, mesh, {}, "--output");
  const TriangleMesh read = read_mesh(path, true, "mesh.file");
  for (std::size_t t = 0; t < read.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d p = mesh.positions[mesh.triangles[t][c]];
      const Vec3d q = read.positions[read.triangles[t][c]];
      // One unit in the last place: Assimp's own number parser may round a digit the other way.
      EXPECT_NEAR(q.x, float(p.x), 1.2e-7);
      EXPECT_NEAR(q.y, float(p.y), 1.2e-7);
      EXPECT_NEAR(q.z, float(p.z), 1.2e-7);
    }
  }
}

TEST_P(MeshFormat, writing_twice_gives_the_same_bytes) {
  const TemporaryFolder folder;
  const auto a = folder / (std::string("a") + GetParam()),
             b = folder / (std::string("b") + GetParam());
  write_mesh(a, small_mesh(), {}, "--output");
  write_mesh(b, small_mesh(), {}, "--output");
  EXPECT_EQ(bytes_at(a), bytes_at(b));
  EXPECT_FALSE(bytes_at(a).empty());
}

TEST_P(MeshFormat, file_names_neither_its_folder_nor_itself) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("unmistakable") + GetParam());
  write_mesh(path, small_mesh(), {}, "--output");
  EXPECT_THAT(bytes_at(path), ::testing::Not(HasSubstr("unmistakable")));
  EXPECT_THAT(bytes_at(path), ::testing::Not(HasSubstr(folder.path().string())));
}

TEST_P(MeshFormat, written_file_replaces_the_old_one_and_leaves_nothing_beside_it) {
  const TemporaryFolder folder;
  const std::string name = std::string("knot") + GetParam();
  const auto path = folder.file(name, "old");
  write_mesh(path, small_mesh(), {}, "--output");
  EXPECT_THAT(folder.names(), ElementsAre(name));
  EXPECT_GT(std::filesystem::file_size(path), 1000u);
}

TEST_P(MeshFormat, place_that_cannot_be_written_is_refused_naming_the_flag) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("missing/knot") + GetParam());
  const std::string error = error_of([&] { write_mesh(path, small_mesh(), {}, "--output"); });
  EXPECT_THAT(error, HasSubstr("--output"));
  EXPECT_THAT(error, HasSubstr(path.string()));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST_P(MeshFormat, folder_in_place_of_the_file_is_refused_and_kept) {
  const TemporaryFolder folder;
  const std::string name = std::string("knot") + GetParam();
  std::filesystem::create_directory(folder / name);
  EXPECT_THAT(error_of([&] { write_mesh(folder / name, small_mesh(), {}, "--output"); }),
              HasSubstr("--output"));
  EXPECT_THAT(folder.names(), ElementsAre(name));
}

TEST(WriteMesh, unknown_extension_is_refused_naming_the_flag_and_the_known_ones) {
  const TemporaryFolder folder;
  for (const char* name : {"knot.stl", "knot.fbx", "knot", "knot.", "knot.objx", ".obj"}) {
    const auto path = folder.file(name, "old");
    const std::string error = error_of([&] { write_mesh(path, small_mesh(), {}, "--output"); });
    EXPECT_THAT(error, HasSubstr("--output")) << name;
    EXPECT_THAT(error, HasSubstr(".obj or .ply")) << name;
    EXPECT_EQ(bytes_at(path), "old") << name;
  }
}

TEST(WriteMesh, knot_of_the_paper_has_the_papers_counts) {
  const TemporaryFolder folder;
  const auto path = folder / "knot.obj";
  write_mesh(path, knot_mesh(KnotSpec{}), {}, "--output");
  const std::string text = bytes_at(path);
  EXPECT_EQ(testing::lines_with(text, "v "), 31529);  // (768 + 1) (40 + 1)
  EXPECT_EQ(testing::lines_with(text, "f "), 61440);  // 2 * 768 * 40
}

}  // namespace
}  // namespace lumaknot
