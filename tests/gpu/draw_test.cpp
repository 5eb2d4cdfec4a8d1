// The pictures that lumaknot-gpu draws, in each API.
#include <cmath>
#include <random>

#include "tests/gpu/testing.h"

namespace lumaknot::gpu {
namespace {

using Draws = EachApi;

/// A vertex of the mesh with arbitrary normal and texture coordinate.
std::vector<float> vertex(float x, float y, float z, std::array<float, 3> normal = {0, 0, 1},
                          std::array<float, 2> uv = {0, 0}) {
  return {x, y, z, normal[0], normal[1], normal[2], uv[0], uv[1]};
}

std::vector<float> joined(std::initializer_list<std::vector<float>> parts) {
  std::vector<float> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Passes the vertex on with its normal and texture coordinate, y pointing to the image's top.
constexpr const char* kAttributes =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec2 uv;\n";

class MeshDraws : public EachApi {
 protected:
  std::string mesh_vertex() const {
    return header({}) + kAttributes + varying("out", 0, "vec3 n") + varying("out", 1, "vec2 t") +
           fmt::format(
               "void main() {{ n = normal; t = uv;\n"
               "gl_Position = vec4(position.x, position.y * {:.1f}, position.z, 1.0); }}\n",
               top());
  }
  std::string mesh_fragment(const std::string& statements) const {
    return header({}) + varying("in", 0, "vec3 n") + varying("in", 1, "vec2 t") +
           "layout(location = 0) out vec4 color;\nvoid main() {\n" + statements + "\n}\n";
  }
};

TEST_P(Draws, first_row_is_the_top_and_pixels_are_sampled_at_their_centres) {
  set_size(8, 4);
  const std::vector<Pixel> image = shaded("color = vec4(place, 0.0, 1.0);");
  ASSERT_EQ(image.size(), 32u);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Pixel& p = image[y * 8 + x];
      // Interpolated from -1 ... 3 in float: a few roundings of numbers up to 3.
      EXPECT_NEAR(p[0], (x + 0.5) / 4 - 1, 1e-6);
      EXPECT_NEAR(p[1], 1 - (y + 0.5) / 2, 1e-6);
    }
  }
}

TEST_P(Draws, values_are_floats_without_a_clamp) {
  const std::vector<Pixel> image = shaded("color = vec4(-2.5, 1.0e10, 1.0e-10, 0.25);");
  EXPECT_EQ(image.at(5), (Pixel{-2.5f, 1e10f, 1e-10f, 0.25f}));
}

TEST_P(Draws, uniforms_of_every_size_arrive_and_matrices_are_column_by_column) {
  const std::vector<TestUniform> uniforms{
      {"mat4", "four", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}},
      {"mat3", "three", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"vec3", "eye", {0.5f, 0.25f, 0.125f}},
      {"float", "shininess", {55}},
      {"vec4", "last", {1, 10, 100, 1000}}};
  const std::vector<Pixel> image = shaded(
      "vec4 a = four * vec4(0.0, 1.0, 0.0, 0.0);\n"  // the second column
      "vec3 b = three * vec3(0.0, 0.0, 1.0);\n"      // the third
      "color = vec4(a.x * 10.0 + a.w, b.x * 10.0 + b.z, dot(eye, vec3(8.0, 8.0, 8.0)) + "
      "shininess,\n"
      "             dot(last, vec4(1.0)));",
      uniforms);
  EXPECT_EQ(image.at(0), (Pixel{58, 79, 62, 1111}));
}

TEST_P(Draws, texture_row_zero_is_at_v_zero_and_repeats) {
  add_texture("t", 2, 2, "nearest", {1, 0, 0, 1, 2, 0, 0, 1, 3, 0, 0, 1, 4, 0, 0, 1});
  const std::vector<Pixel> image = shaded(
      "color = vec4(texture(t, vec2(0.25, 0.25)).r, texture(t, vec2(0.75, 0.25)).r,\n"
      "             texture(t, vec2(-0.75, 1.75)).r, texture(t, vec2(3.75, -0.25)).r);");
  EXPECT_EQ(image.at(0), (Pixel{1, 2, 3, 4}));
}

/// Random numbers in [low, high).
std::vector<float> random_floats(std::size_t count, float low, float high) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(low, high);
  std::vector<float> all(count);
  for (float& value : all) value = uniform(random);
  return all;
}

/// One channel of a repeated n x n RGBA texture, filtered in double.
double bilinear(const std::vector<float>& texels, int n, double u, double v, int channel) {
  const double x = u * n - 0.5, y = v * n - 0.5;
  const double fx = x - std::floor(x), fy = y - std::floor(y);
  const auto at = [&](int dx, int dy) {
    const int i = (int(std::floor(x)) + dx + n) % n, j = (int(std::floor(y)) + dy + n) % n;
    return double(texels[(j * n + i) * 4 + channel]);
  };
  const double low = at(0, 0) + (at(1, 0) - at(0, 0)) * fx;
  const double high = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
  return low + (high - low) * fy;
}

TEST_P(Draws, linear_filter_is_the_bilinear_filter_in_float) {
  constexpr int kTexels = 64, kPixels = 128;
  const std::vector<float> texels = random_floats(kTexels * kTexels * 4, 0, 1);
  const std::vector<float> places = random_floats(kPixels * kPixels * 4, 0, 1);
  set_size(kPixels, kPixels);
  add_texture("t", kTexels, kTexels, "linear", texels);
  add_texture("places", kPixels, kPixels, "nearest", places);
  const std::vector<Pixel> image = shaded(
      "vec4 p = texelFetch(places, ivec2(floor((place * 0.5 + 0.5) * 128.0)), 0);\n"
      "color = texture(t, p.xy);");
  ASSERT_EQ(image.size(), std::size_t(kPixels * kPixels));
  double worst = 0;
  for (int i = 0; i < kPixels * kPixels; ++i) {
    // The image's first row is the texture's last.
    const int from = (kPixels - 1 - i / kPixels) * kPixels + i % kPixels;
    const double u = places[from * 4], v = places[from * 4 + 1];
    for (int c = 0; c < 4; ++c) {
      const float got = image[std::size_t(i)][std::size_t(c)];
      worst = std::max(worst, std::abs(got - bilinear(texels, kTexels, u, v, c)));
    }
  }
  // u * 64 is exact; half a texel off it and three blends round to 2^-24 each, doubled for safety.
  EXPECT_LT(worst, 5e-7);
}

TEST_P(Draws, kernel_run_reads_4096_inputs_as_they_are) {
  const std::vector<float> inputs = random_floats(4096 * 2 * 4, -1e6f, 1e6f);
  const std::vector<float> texture{0, 0, 0, 0};
  set_size(64, 64);
  add_texture("color_texture", 1, 1, "linear", texture);
  add_texture("inputs", 4096, 2, "nearest", inputs);
  // Pixels are counted from the top left, fragments from the API's origin.
  const std::string row = vulkan() ? "int(gl_FragCoord.y)" : "63 - int(gl_FragCoord.y)";
  const std::vector<Pixel> image = shaded(
      "int k = (" + row +
      ") * 64 + int(gl_FragCoord.x);\n"
      "vec4 a = texelFetch(inputs, ivec2(k, 0), 0), b = texelFetch(inputs, ivec2(k, 1), 0);\n"
      "color = vec4(a.xy, b.zw) + texture(color_texture, a.xy);");
  ASSERT_EQ(image.size(), 4096u);
  for (std::size_t k = 0; k < 4096; ++k) {
    const std::size_t second = (4096 + k) * 4;
    EXPECT_EQ(image[k],
              (Pixel{inputs[k * 4], inputs[k * 4 + 1], inputs[second + 2], inputs[second + 3]}));
  }
}

TEST_P(Draws, draws_of_a_job_know_nothing_of_each_other) {
  const std::vector<TestUniform> one{{"float", "value", {1}}}, two{{"float", "value", {2}}};
  add_draw("first", full_screen(), fragment("color = vec4(value);", one), one);
  add_draw("second", full_screen(),
           fragment("if (place.x > 0.0) discard;\ncolor = vec4(value);", two), two);
  const std::vector<Pixel> second = drawn("second");
  EXPECT_EQ(pixels("first.bin").at(3), (Pixel{1, 1, 1, 1}));
  EXPECT_EQ(second.at(0), (Pixel{2, 2, 2, 2}));
  EXPECT_EQ(second.at(3), (Pixel{0, 0, 0, 0}));
}

TEST_P(Draws, same_job_gives_the_same_bytes) {
  set_size(64, 64);
  shaded("color = vec4(sin(place.x * 40.0), exp2(place.y), pow(place.x + 2.0, 7.3), 1.0);");
  const std::string first = read_file(path("shaded.bin"), "first");
  EXPECT_TRUE(run_job(job_).succeeded());
  EXPECT_EQ(read_file(path("shaded.bin"), "second"), first);
}

TEST_P(MeshDraws, attributes_reach_the_shader_and_the_rest_stays_empty) {
  // Covers the pixels of the lower left half: x + y < 0 with y up.
  set_mesh(joined({vertex(-1, -1, 0.5f, {1, 2, 3}, {4, 5}), vertex(1, -1, 0.5f, {1, 2, 3}, {4, 5}),
                   vertex(-1, 1, 0.5f, {1, 2, 3}, {4, 5})}),
           {0, 1, 2});
  add_draw("half", mesh_vertex(), mesh_fragment("color = vec4(n.x + 10.0 * n.y, n.z, t);"));
  const std::vector<Pixel> image = drawn("half");
  ASSERT_EQ(image.size(), 16u);
  EXPECT_EQ(image[0 * 4 + 3], (Pixel{0, 0, 0, 0}));  // top right
  EXPECT_EQ(image[1 * 4 + 3], (Pixel{0, 0, 0, 0}));
  const Pixel& low_left = image[3 * 4 + 0];
  const Pixel expected{21, 3, 4, 5};
  // Interpolating three equal numbers rounds a few times.
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(low_left[c], expected[c], 1e-5);
}

/// Two triangles over the whole image at two depths, of either winding.
std::vector<float> two_sheets(float first_depth, float second_depth) {
  return joined({vertex(-1, -1, first_depth, {1, 0, 0}), vertex(3, -1, first_depth, {1, 0, 0}),
                 vertex(-1, 3, first_depth, {1, 0, 0}), vertex(-1, -1, second_depth, {0, 1, 0}),
                 vertex(-1, 3, second_depth, {0, 1, 0}), vertex(3, -1, second_depth, {0, 1, 0})});
}

TEST_P(MeshDraws, nearer_triangle_hides_the_farther_in_any_order_and_winding) {
  for (const bool first_nearer : {true, false}) {
    job_["draws"].clear();
    set_mesh(two_sheets(first_nearer ? 0.25f : 0.75f, 0.5f), {0, 1, 2, 3, 4, 5});
    add_draw("sheets", mesh_vertex(), mesh_fragment("color = vec4(n.xy, 0.0, 1.0);"));
    const Pixel seen = drawn("sheets").at(5);
    EXPECT_NEAR(seen[0], first_nearer ? 1 : 0, 1e-6);
    EXPECT_NEAR(seen[1], first_nearer ? 0 : 1, 1e-6);
  }
}

TEST_P(MeshDraws, at_equal_depth_the_later_triangle_is_seen) {
  set_mesh(two_sheets(0.5f, 0.5f), {0, 1, 2, 3, 4, 5});
  add_draw("sheets", mesh_vertex(), mesh_fragment("color = vec4(n.xy, 0.0, 1.0);"));
  EXPECT_NEAR(drawn("sheets").at(5)[1], 1, 1e-6);
}

const auto kApis = ::testing::Values("gl", "gles", "vulkan");
INSTANTIATE_TEST_SUITE_P(Gpu, Draws, kApis, api_name);
INSTANTIATE_TEST_SUITE_P(Gpu, MeshDraws, kApis, api_name);

}  // namespace
}  // namespace lumaknot::gpu
