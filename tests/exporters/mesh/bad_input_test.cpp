// Files that are cut, changed or malicious: each is read as a mesh or refused, quickly.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <ctime>
#include <functional>
#include <random>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using testing::MeshSample;
using testing::TemporaryFolder;

class BadMesh : public ::testing::TestWithParam<MeshSample> {};
INSTANTIATE_TEST_SUITE_P(, BadMesh, ::testing::ValuesIn(testing::mesh_samples()),
                         [](const auto& sample) { return std::string(sample.param.name); });

/// Whether `bytes` are read. Anything but a valid mesh or an Error of one line fails the test.
bool is_read(const MeshSample& sample, const std::string& bytes) {
  TriangleMesh mesh;
  const std::string error = error_of([&] { mesh = testing::read_bytes(sample.reader, bytes); });
  if (error.empty()) {
    testing::expect_consistent(mesh);
    return true;
  }
  EXPECT_TRUE(error.starts_with("mesh.file knot")) << error;
  EXPECT_EQ(error.find('\n'), error.npos) << error;
  return false;
}

TEST_P(BadMesh, whole_file_is_read) { EXPECT_TRUE(is_read(GetParam(), GetParam().bytes)); }

TEST_P(BadMesh, file_cut_at_any_byte_is_read_or_refused) {
  const MeshSample& sample = GetParam();
  int refused = 0;
  for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
    refused += !is_read(sample, sample.bytes.substr(0, size));
    ASSERT_FALSE(HasFailure()) << "cut to " << size;
  }
  EXPECT_GT(refused, 0);
}

TEST_P(BadMesh, file_with_changed_bytes_is_read_or_refused) {
  const MeshSample& sample = GetParam();
  std::mt19937 random(12345);
  const auto below = [&](std::size_t limit) { return std::size_t(random()) % limit; };
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = sample.bytes;
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      char& byte = bytes[below(bytes.size())];
      // A bit, any byte, or a character with a meaning in text.
      const std::size_t kind = below(3);
      byte = kind == 0   ? char(byte ^ (1 << below(8)))
             : kind == 1 ? char(below(256))
                         : "0123456789-+.eE/,<>{}#\\\n \"*"[below(27)];
    }
    refused += !is_read(sample, bytes);
    ASSERT_FALSE(HasFailure()) << "change " << i;
  }
  EXPECT_GT(refused, 0);
}

std::string repeated(std::string_view text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

struct Heavy {
  const char* name;
  std::string bytes;
};

/// A few megabytes each, which are read far before the error, or with a wrong size.
std::vector<Heavy> heavy_files() {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\n"
      "end_header\n";
  std::string om = testing::knot_om();
  om.replace(4, 12, "\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff");
  return {
      {"faces.obj", triangle + repeated("f 1 2 3\n", 300'000)},
      {"points.obj", repeated("v 0 0 0\n", 300'000)},
      {"last.obj", triangle + repeated("v 0.123 4.567 8.901\n", 120'000) + "f 1 2 9999999\n"},
      {"corners.obj", triangle + "f" + repeated(" 1 2 3", 400'000) + "\n"},
      {"words.obj", repeated("word ", 500'000)},
      {"lie.ply", header + std::string(2'000'000, '\0')},
      {"lie.off", "OFF\n4294967295 4294967295 0\n" + repeated("0 0 0\n", 300'000)},
      {"lie.om", om + std::string(2'000'000, '\0')},
      {"lie.stl", std::string(80, '\0') + "\xff\xff\xff\xff" + std::string(2'000'000, '\0')},
      {"flat.stl", std::string(80, '\0') + testing::raw(std::uint32_t(40'000)) +
                       std::string(50 * 40'000, '\0')},
      {"open.pov", repeated("/*", 1'000'000)},
      {"deep.pov", "mesh2 {" + repeated("{", 1'000'000)},
      {"lie.pov", "mesh2 { vertex_vectors { 4294967295" + repeated(", <0,0,0>", 200'000)},
  };
}

#if defined(__SANITIZE_ADDRESS__)
// The sanitizer keeps freed memory and checks each access.
constexpr double kMaxSeconds = 3;
constexpr long kMaxKibibytes = 1024 * 1024;
#elif defined(NDEBUG)
constexpr double kMaxSeconds = 0.25;  // 0.1 on an idle core; tests run in parallel
constexpr long kMaxKibibytes = 64 * 1024;
#else
constexpr double kMaxSeconds = 1;
constexpr long kMaxKibibytes = 64 * 1024;
#endif

/// Reads in a process of its own, to measure its own peak memory, and reports the error.
[[noreturn]] void refuse_soon(const Heavy& heavy) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.file(heavy.name, heavy.bytes);
  rusage before{}, after{};
  ::getrusage(RUSAGE_SELF, &before);
  const std::clock_t start = std::clock();
  const std::string error = error_of([&] { read_mesh(path, false, "mesh.file"); });
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  ::getrusage(RUSAGE_SELF, &after);
  const long kibibytes = after.ru_maxrss - before.ru_maxrss;
  std::filesystem::remove_all(folder.path());
  const bool is_good =
      error.starts_with("mesh.file ") && seconds < kMaxSeconds && kibibytes < kMaxKibibytes;
  fmt::print(stderr, "{}: {} s, {} KiB: {}\n", is_good ? "good" : "bad", seconds, kibibytes, error);
  std::_Exit(is_good ? 0 : 1);
}

TEST(BadMeshDeathTest, heavy_files_are_refused_quickly_and_in_little_memory) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const Heavy& heavy : heavy_files()) {
    EXPECT_EXIT(refuse_soon(heavy), ::testing::ExitedWithCode(0), "good: ") << heavy.name;
  }
}

}  // namespace
}  // namespace lumaknot
