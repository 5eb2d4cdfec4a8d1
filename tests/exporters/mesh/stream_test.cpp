// The building blocks of the mesh writers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <charconv>
#include <limits>
#include <mutex>
#include <random>
#include <set>
#include <sstream>

#include "exporters/mesh/faces.h"
#include "exporters/mesh/weld.h"
#include "exporters/obj/format.h"
#include "exporters/off/format.h"
#include "exporters/ply/format.h"
#include "exporters/povray/format.h"
#include "exporters/stl/format.h"
#include "exporters/text/numbers.h"
#include "meshgen/closed_mesh.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using oneapi::tbb::global_control;
using ::testing::ElementsAre;

std::string text_of(float value) {
  char text[kFloatBytes];
  return {text, put_float(text, value)};
}

/// The standard library's shortest digits.
std::string shortest(float value) {
  char text[32];
  return {text, std::to_chars(text, std::end(text), value, std::chars_format::scientific).ptr};
}

/// Without leading and trailing zeros.
std::string significant_digits(const std::string& number) {
  std::string digits = number.substr(0, number.find('e'));
  std::erase_if(digits, [](char c) { return c == '.' || c == '-'; });
  digits.erase(0, digits.find_first_not_of('0'));
  return digits.substr(0, digits.find_last_not_of('0') + 1);
}

TEST(PutFloat, random_numbers_read_back_exactly_in_the_fewest_digits) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<float>(std::uint32_t(random()));
    if (!std::isfinite(value)) continue;
    const std::string text = text_of(value);
    float read = 0;
    ASSERT_EQ(std::from_chars(text.data(), text.data() + text.size(), read).ptr,
              text.data() + text.size());
    ASSERT_EQ(std::bit_cast<std::uint32_t>(read), std::bit_cast<std::uint32_t>(value)) << text;
    ASSERT_EQ(significant_digits(text), significant_digits(shortest(value))) << text;
  }
}

TEST(PutFloat, longest_numbers_fit_in_their_room) {
  for (const float value : {-1.2345678e15f, -9.999999e15f, -1.2345678e-38f, -1.4e-45f,
                            -1.2345678e-4f, std::numeric_limits<float>::lowest()}) {
    char text[2 * kFloatBytes];
    EXPECT_LE(put_float(text, value) - text, std::ptrdiff_t(kFloatBytes)) << value;
  }
  EXPECT_EQ(text_of(-0.f), "-0");
}

TEST(Weld, copies_of_a_position_get_the_number_of_its_first_use) {
  const std::vector<Vec3d> positions{{1, 2, 3}, {0, 0, 0},    {1, 2, 3},
                                     {3, 2, 1}, {-0.0, 0, 0}, {1 + 1e-12, 2, 3}};
  const Weld weld = lumaknot::weld(positions);
  EXPECT_THAT(weld.position, ElementsAre(0, 1, 0, 2, 1, 0));
  EXPECT_EQ(weld.repeats, (std::vector<bool>{false, false, true, false, true, true}));
  EXPECT_EQ(weld.count, 3u);
}

TEST(Weld, knot_has_as_many_positions_as_vertices_of_its_closed_surface) {
  const TriangleMesh mesh = knot_mesh(testing::small_knot());
  EXPECT_EQ(weld(mesh.positions).count, closed_mesh(testing::small_knot(), mesh).n_vertices());
  EXPECT_EQ(weld({}).count, 0u);
}

TEST(Weld, neighbouring_float32_stay_apart) {
  std::vector<Vec3d> positions;
  float x = 1;
  for (int i = 0; i < 10000; ++i, x = std::nextafter(x, 2.f)) positions.push_back({x, 0, 0});
  EXPECT_EQ(weld(positions).count, 10000u);
}

TEST(QuadOf, every_rotation_of_both_halves_is_the_quad_beginning_with_the_first) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Triangle a{7, 8, 9}, b{7, 9, 5};  // of 7 8 9 5
      std::rotate(a.begin(), a.begin() + std::ptrdiff_t(i), a.end());
      std::rotate(b.begin(), b.begin() + std::ptrdiff_t(j), b.end());
      Quad expected{7, 8, 9, 5};
      std::rotate(expected.begin(), std::ranges::find(expected, a[0]), expected.end());
      EXPECT_EQ(quad_of(a, b), expected);
    }
  }
}

std::string lines(std::size_t count) {
  std::ostringstream stream;
  write_items(stream, count, kIntegerBytes + 1, [](std::size_t i, char* at) {
    at = put_integer(at, std::uint32_t(i));
    *at++ = '\n';
    return at;
  });
  return std::move(stream).str();
}

TEST(WriteItems, items_come_in_order_and_none_is_lost) {
  for (const std::size_t count : {0, 1, 23831, 23832, 500000}) {  // 23831 make a chunk
    std::istringstream text(lines(count));
    std::size_t expected = 0, value = 0;
    while (text >> value) ASSERT_EQ(value, expected++);
    EXPECT_EQ(expected, count);
  }
}

using Writer = void (*)(std::ostream&, const TriangleMesh&, const MeshFileOptions&);
constexpr Writer kWriters[] = {obj::write, ply::write, stl::write, off::write,
                               povray::write_pov_include};

/// Large enough for several chunks per thread.
TriangleMesh large_mesh() {
  KnotSpec knot;
  knot.segments = 400;
  knot.sides = 60;
  return knot_mesh(knot);
}

std::string written(Writer write, const TriangleMesh& mesh, std::size_t threads, bool ascii) {
  const global_control limit(global_control::max_allowed_parallelism, threads);
  std::ostringstream stream;
  write(stream, mesh, {.ascii = ascii});
  return std::move(stream).str();
}

TEST(MeshWriters, bytes_are_the_same_whatever_the_number_of_threads) {
  const TriangleMesh mesh = large_mesh();
  for (const Writer write : kWriters) {
    for (const bool ascii : {false, true}) {
      const std::string one = written(write, mesh, 1, ascii);
      EXPECT_GT(one.size(), 500000u);
      EXPECT_TRUE(one == written(write, mesh, 4, ascii));  // too long to print
    }
  }
}

/// A disk that takes only so many bytes.
class FullDisk : public std::streambuf {
 public:
  explicit FullDisk(std::streamsize room) : room_(room) {}
  std::streamsize asked = 0;

 private:
  std::streamsize xsputn(const char*, std::streamsize size) override {
    asked += size;
    const std::streamsize taken = std::min(size, room_);
    room_ -= taken;
    return taken;
  }
  int overflow(int) override { return traits_type::eof(); }

  std::streamsize room_;
};

TEST(MeshWriters, full_disk_leaves_the_stream_bad_and_ends_the_work) {
  const TriangleMesh mesh = large_mesh();
  for (const Writer write : kWriters) {
    for (const std::streamsize room : {0, 100, 300000}) {
      FullDisk disk(room);
      std::ostream stream(&disk);
      write(stream, mesh, {});
      EXPECT_FALSE(stream);
      EXPECT_LT(disk.asked, 300000 + (1 << 18));  // the chunk that did not fit was the last
    }
  }
}

TEST(WriteItems, few_buffers_serve_many_chunks) {
  std::mutex mutex;
  std::set<const char*> buffers;
  std::size_t chunks = 0;
  std::ostringstream stream;
  write_ranges(stream, std::size_t{1} << 26, 1, [&](std::size_t, std::size_t, char* at) {
    const std::lock_guard lock(mutex);
    buffers.insert(at);
    ++chunks;
    return at;
  });
  EXPECT_EQ(chunks, 256u);
  EXPECT_LE(buffers.size(), 32u);
}

}  // namespace
}  // namespace lumaknot
