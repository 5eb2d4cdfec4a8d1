// A mesh format is a file and a line in its list: see toys_test.cpp.
#include <gmock/gmock.h>

#include "exporters/mesh/format.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::tetrahedron;

TEST(ToyFormat, is_written_and_read_again) {
  const testing::TemporaryFolder folder;
  write_mesh(folder / "mesh.toy", tetrahedron(), {.ascii = true}, "--output");
  EXPECT_THAT(testing::bytes_at(folder / "mesh.toy"), EndsWith("\n1 0 0 0 1 0 0 0 0.1 \n"));
  const TriangleMesh mesh = read_mesh(folder / "mesh.toy", false, "mesh.file");
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.positions[mesh.triangles[3][0]], (Vec3d{1, 0, 0}));
}

TEST(ToyFormat, is_listed_with_the_others) {
  const testing::TemporaryFolder folder;
  const auto other = folder.file("mesh.other", "1 2 3");
  EXPECT_THAT(error_of([&] { read_mesh(other, false, "mesh.file"); }), EndsWith(" .toy"));
  EXPECT_THAT(error_of([&] { check_mesh_output(other, {}, "--output"); }), EndsWith(" or .toy"));
  EXPECT_EQ(mesh_endings(&MeshFormat::has_text).back(), ".toy");
}

TEST(ToyFormat, refuses_what_its_entry_does_not_have) {
  const auto error = [](const MeshFileOptions& options) {
    return error_of([&] { check_mesh_output("mesh.toy", options, "--output"); });
  };
  EXPECT_EQ(error({.ascii = true}), "");
  EXPECT_THAT(error({.quads = true}), HasSubstr("mesh.toy can't hold quads"));
  EXPECT_THAT(error({.tangents = true}), HasSubstr("mesh.toy can't hold tangents"));
}

TEST(ToyFormat, file_that_is_cut_short_is_refused_with_its_line) {
  const testing::TemporaryFolder folder;
  const auto path = folder.file("cut.toy", "0 0 0 1 0 0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(error_of([&] { read_mesh(path, false, "mesh.file"); }), HasSubstr("cut.toy, line 2"));
}

}  // namespace
}  // namespace lumaknot
