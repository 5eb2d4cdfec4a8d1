// What every entry of the table of mesh formats promises.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot {
namespace {

using testing::TemporaryFolder;

TEST(MeshFormats, have_endings_in_lower_case_that_choose_one_reader_and_one_writer) {
  for (const MeshFormat* format : mesh_formats()) EXPECT_TRUE(format->read || format->write);
  for (const MeshFormatFilter& is_selected :
       {MeshFormatFilter(&MeshFormat::read), MeshFormatFilter(&MeshFormat::write)}) {
    std::set<std::string> seen;
    for (const std::string& ending : mesh_endings(is_selected)) {
      EXPECT_TRUE(ending.starts_with('.')) << ending;
      EXPECT_TRUE(std::ranges::none_of(ending, [](char c) { return c >= 'A' && c <= 'Z'; }));
      EXPECT_TRUE(seen.insert(ending).second) << ending << " is of two formats";
    }
  }
}

TEST(MeshFormats, that_are_written_are_text_or_binary) {
  for (const MeshFormat* format : mesh_formats()) {
    EXPECT_EQ(format->has_text || format->has_binary, format->write != nullptr)
        << format->endings[0];
  }
}

TEST(MeshFormats, that_are_written_are_read_again) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = knot_mesh(testing::small_knot());
  for (const std::string& ending : mesh_endings(&MeshFormat::write)) {
    const auto path = folder / ("knot" + ending);
    write_mesh(path, mesh, {}, "--output");
    const TriangleMesh again = read_mesh(path, false, "mesh.file");
    testing::expect_consistent(again);
    EXPECT_EQ(again.triangles.size(), mesh.triangles.size()) << ending;
  }
}

TEST(MeshFormats, that_are_read_have_a_sample_that_the_tests_of_bad_input_spoil) {
  std::set<std::string> sampled{".glb"};  // by tests/exporters/gltf/bad_input_test.cpp
  for (const testing::MeshSample& sample : testing::mesh_samples()) sampled.insert(sample.ending);
  for (const MeshFormat* format : mesh_formats()) {
    const std::string ending(format->endings[0]);
    EXPECT_TRUE(!format->read || sampled.contains(ending)) << ending;
  }
}

}  // namespace
}  // namespace lumaknot
