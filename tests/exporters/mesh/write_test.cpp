#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "exporters/mesh/format.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::AllOf;
using testing::bytes_at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TemporaryFolder;

TriangleMesh small_mesh() { return knot_mesh(testing::small_knot()); }

/// The endings of the formats that are written as one file.
std::vector<std::string> single_files() {
  std::vector<std::string> endings = mesh_endings(&MeshFormat::write);
  std::erase(endings, ".gltf");  // two: tests/exporters/gltf
  return endings;
}

class WrittenFile : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, WrittenFile, ::testing::ValuesIn(single_files()),
                         [](const auto& ending) { return ending.param.substr(1); });

TEST_P(WrittenFile, writing_twice_gives_the_same_bytes) {
  const TemporaryFolder folder;
  const auto a = folder / ("a" + GetParam()), b = folder / ("b" + GetParam());
  write_mesh(a, small_mesh(), {}, "--output");
  write_mesh(b, small_mesh(), {}, "--output");
  EXPECT_EQ(bytes_at(a), bytes_at(b));
  EXPECT_FALSE(bytes_at(a).empty());
}

TEST_P(WrittenFile, file_names_neither_its_folder_nor_itself) {
  const TemporaryFolder folder;
  const auto path = folder / ("unmistakable" + GetParam());
  write_mesh(path, small_mesh(), {}, "--output");
  EXPECT_THAT(bytes_at(path), ::testing::Not(HasSubstr("unmistakable")));
  EXPECT_THAT(bytes_at(path), ::testing::Not(HasSubstr(folder.path().string())));
}

TEST_P(WrittenFile, written_file_replaces_the_old_one_and_leaves_nothing_else) {
  const TemporaryFolder folder;
  const std::string name = "knot" + GetParam();
  const auto path = folder.file(name, "old");
  write_mesh(path, small_mesh(), {}, "--output");
  EXPECT_THAT(folder.names(), ElementsAre(name));
  EXPECT_GT(std::filesystem::file_size(path), 1000u);
}

TEST_P(WrittenFile, place_that_cannot_be_written_is_refused_naming_the_flag) {
  const TemporaryFolder folder;
  const auto path = folder / ("missing/knot" + GetParam());
  const std::string error = error_of([&] { write_mesh(path, small_mesh(), {}, "--output"); });
  EXPECT_THAT(error, HasSubstr("--output"));
  EXPECT_THAT(error, HasSubstr(path.string()));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST_P(WrittenFile, folder_in_place_of_the_file_is_refused_and_kept) {
  const TemporaryFolder folder;
  const std::string name = "knot" + GetParam();
  std::filesystem::create_directory(folder / name);
  EXPECT_THAT(error_of([&] { write_mesh(folder / name, small_mesh(), {}, "--output"); }),
              HasSubstr("--output"));
  EXPECT_THAT(folder.names(), ElementsAre(name));
}

/// No file can grow beyond `bytes` while it lives, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

TEST_P(WrittenFile, full_disk_is_an_error_and_leaves_the_old_file_alone) {
  const TemporaryFolder folder;
  const auto path = folder.file("knot" + GetParam(), "old");
  std::string error;
  {
    const FileSizeLimit limit(2000);
    error = error_of([&] { write_mesh(path, small_mesh(), {}, "--output"); });
  }
  EXPECT_THAT(error, AllOf(HasSubstr("--output"), HasSubstr(path.string()), HasSubstr("disk")));
  EXPECT_EQ(bytes_at(path), "old");
  EXPECT_THAT(folder.names(), ElementsAre(path.filename().string()));
}

TEST_P(WrittenFile, number_beyond_float32_is_refused_naming_its_vertex) {
  const TemporaryFolder folder;
  const auto path = folder / ("knot" + GetParam());
  for (const double bad : {1e39, -1e39, std::numeric_limits<double>::quiet_NaN()}) {
    TriangleMesh mesh = testing::tetrahedron();
    mesh.positions[2].y = bad;
    EXPECT_THAT(error_of([&] { write_mesh(path, mesh, {}, "--output"); }),
                AllOf(HasSubstr("--output"), HasSubstr("vertex 2 "), HasSubstr("float32")));
    mesh = testing::tetrahedron();
    mesh.uvs[3].v = bad;
    EXPECT_THAT(error_of([&] { write_mesh(path, mesh, {}, "--output"); }), HasSubstr("vertex 3 "));
    EXPECT_THAT(folder.names(), IsEmpty());
  }
}

/// Three triangles at one edge.
TriangleMesh fan_at_an_edge() {
  TriangleMesh mesh = testing::tetrahedron();
  mesh.positions.push_back({1, 1, 1});
  mesh.normals.push_back({0, 0, 1});
  mesh.uvs.push_back({});
  mesh.triangles.push_back({0, 1, 4});
  return mesh;
}

TEST_P(WrittenFile, edge_of_three_triangles_is_written_unless_the_format_has_none) {
  const TemporaryFolder folder;
  const auto path = folder / ("fan" + GetParam());
  const std::string error = error_of([&] { write_mesh(path, fan_at_an_edge(), {}, "--output"); });
  if (path.extension() == ".om") {
    EXPECT_THAT(error, AllOf(HasSubstr("1 of 5 triangles"), HasSubstr("write .obj")));
    EXPECT_THAT(folder.names(), IsEmpty());
  } else {
    EXPECT_EQ(error, "");
    EXPECT_FALSE(bytes_at(path).empty());
  }
}

TEST(WriteMesh, unknown_extension_is_refused_naming_the_flag_and_the_known_ones) {
  const TemporaryFolder folder;
  for (const char* name : {"knot.blend", "knot.fbx", "knot", "knot.", "knot.objx", ".obj"}) {
    const auto path = folder.file(name, "old");
    const std::string error = error_of([&] { write_mesh(path, small_mesh(), {}, "--output"); });
    EXPECT_THAT(error, HasSubstr("--output")) << name;
    EXPECT_THAT(error, HasSubstr("must end in .obj, .ply, .stl, .off, .om, .glb, .gltf or .inc"))
        << name;
    EXPECT_EQ(bytes_at(path), "old") << name;
  }
}

TEST(CheckMeshOutput, options_that_the_format_does_not_support_are_refused) {
  const auto error = [](const char* path, const MeshFileOptions& options) {
    return error_of([&] { check_mesh_output(path, options, "--output"); });
  };
  EXPECT_EQ(error("k.om", {.ascii = true}),
            "--output k.om can't be text: its format is binary only; end it in .obj, .ply, .stl, "
            ".off or .inc");
  for (const char* path : {"k.obj", "k.ply", "k.stl", "k.off", "k.inc"}) {
    EXPECT_EQ(error(path, {.ascii = true}), "") << path;
  }
  EXPECT_EQ(error("k.stl", {.quads = true}),
            "--output k.stl can't hold quads: its format has triangles only; end it in .obj, .ply "
            "or .off");
  for (const char* path : {"k.om", "k.inc"}) {
    EXPECT_THAT(error(path, {.quads = true}), HasSubstr("quads")) << path;
  }
  for (const char* path : {"k.obj", "k.ply", "k.off"}) {
    EXPECT_EQ(error(path, {.quads = true}), "") << path;
  }
}

TEST(WriteMesh, quads_are_refused_for_a_mesh_without_them) {
  const TemporaryFolder folder;
  TriangleMesh mesh = small_mesh();
  mesh.quads = false;
  EXPECT_THAT(error_of([&] { write_mesh(folder / "k.obj", mesh, {.quads = true}, "--output"); }),
              AllOf(HasSubstr("--output"), HasSubstr("triangles only")));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WriteMesh, knot_of_the_paper_has_the_papers_counts) {
  const TemporaryFolder folder;
  const auto path = folder / "knot.obj";
  write_mesh(path, knot_mesh(KnotSpec{}), {}, "--output");
  const std::string text = bytes_at(path);
  EXPECT_EQ(testing::lines_with(text, "v "), 30720);   // 768 * 40, seams closed
  EXPECT_EQ(testing::lines_with(text, "vt "), 31529);  // (768 + 1) (40 + 1)
  EXPECT_EQ(testing::lines_with(text, "f "), 61440);   // 2 * 768 * 40
}

}  // namespace
}  // namespace lumaknot
