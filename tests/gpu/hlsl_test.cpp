// HLSL of shader model 5, unchanged from Direct3D, drawn by Vulkan: glslangValidator moves register
// tN and sN to binding N + 1, so that a texture and its sampler become one descriptor, and b0 to
// binding 0.
#include "tests/gpu/testing.h"

namespace lumaknot::gpu {
namespace {

/// Binding t0 and s0 separately takes other numbers.
std::vector<std::string> flags(const std::string& first_sampler) {
  return {"-D",
          "-e",
          "main",
          "--shift-texture-binding",
          "1",
          "--shift-sampler-binding",
          first_sampler,
          "--shift-cbuffer-binding",
          "0"};
}

/// The layout is given register by register, so that every compiler agrees with std140.
const std::string kShared = R"(
cbuffer Parameters : register(b0) {
  float4x4 placing : packoffset(c0);
  float3x3 turn : packoffset(c4);
  float3 eye_position : packoffset(c7);
  float shininess : packoffset(c7.w);
};
struct Varyings {
  float4 clip_position : SV_Position;
  float3 normal : TEXCOORD0;
  float2 uv : TEXCOORD1;
};
)";

const std::string kVertex = R"(
struct Attributes {
  float3 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};
Varyings main(Attributes a) {
  Varyings v;
  v.clip_position = mul(placing, float4(a.position, 1.0));
  v.normal = mul(turn, a.normal);
  v.uv = a.uv;
  return v;
}
)";

const std::string kFragment = R"(
Texture2D color_texture : register(t0);
SamplerState color_sampler : register(s0);
Texture2D inputs : register(t1);
float4 main(Varyings v) : SV_Target {
  float4 t = color_texture.Sample(color_sampler, v.uv);
  float4 i = inputs.Load(int3(int(v.clip_position.y) * 2 + int(v.clip_position.x), 0, 0));
  return float4(v.normal.xy, t.x, i.x + eye_position.z * shininess);
}
)";

class Hlsl : public GpuTest {
 protected:
  void SetUp() override {
    if (const std::string why = missing("vulkan"); !why.empty()) FAIL() << why;
  }
  /// One triangle over a 2 x 2 image. The matrix rotates (x, y) by a quarter turn, so it is not
  /// symmetric.
  Json job(const std::string& first_sampler) {
    write("v.hlsl", kShared + kVertex);
    write("f.hlsl", kShared + kFragment);
    compile("v.hlsl", "vert", flags(first_sampler));
    compile("f.hlsl", "frag", flags(first_sampler));
    write("block.bin", bytes_of(std::vector<float>{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0,
                                                   0, 0, 0, 1,  // placing, by columns
                                                   0, 1, 0, 0, -2, 0, 0, 0, 0, 0, 1, 0,  // turn
                                                   9, 9, 2, 50}));  // eye, shininess
    const std::vector<float> a{-1, -1, 0.5f, 3, 4, 5, 0.75f, 0.25f};
    std::vector<float> mesh = a;
    for (const float x : {3.0f, -1.0f}) {
      mesh.insert(mesh.end(), {x, x > 0 ? -1.0f : 3.0f, 0.5f, 3, 4, 5, 0.75f, 0.25f});
    }
    for (std::size_t i = 0; i < mesh.size(); i += 8) mesh[i + 1] = -mesh[i + 1];
    write("mesh.bin", bytes_of(mesh));
    write("indices.bin", bytes_of(std::vector<std::uint32_t>{0, 1, 2}));
    write("color.bin",
          bytes_of(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0}));
    write("inputs.bin",
          bytes_of(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0}));
    return Json::parse(R"({"api": "vulkan", "width": 2, "height": 2,
      "mesh": {"vertices": "mesh.bin", "count": 3, "indices": "indices.bin", "triangles": 1},
      "textures": [
        {"binding": 1, "file": "color.bin", "width": 2, "height": 2, "filter": "linear"},
        {"binding": 2, "file": "inputs.bin", "width": 4, "height": 1, "filter": "nearest"}],
      "draws": [{"vertex": "v.hlsl.spv", "fragment": "f.hlsl.spv", "output": "o.bin",
                 "uniform_block": "block.bin"}]})");
  }
  void expect_drawn(const Json& j) {
    const ProcessResult ended = run_job(j);
    ASSERT_TRUE(ended.succeeded()) << ended.log;
    const std::vector<Pixel> image = pixels("o.bin");
    for (std::size_t k = 0; k < 4; ++k) {
      // turn = ((0 -2 0) (1 0 0) (0 0 1)), normal (3 4 5); texel (1, 0) of the lower row.
      const Pixel expected{-8, 3, 2, float(k + 1) + 100};
      // Interpolation of equal numbers rounds a few times.
      for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(image[k][c], expected[c], 1e-5) << k;
    }
  }
};

TEST_F(Hlsl, texture_and_sampler_share_a_binding_and_the_block_is_std140) {
  expect_drawn(job("1"));
}

TEST_F(Hlsl, texture_and_sampler_may_have_bindings_of_their_own) {
  Json j = job("8");
  j["textures"][0]["sampler_binding"] = 8;
  expect_drawn(j);
}

TEST_F(Hlsl, kernel_run_needs_no_vertices) {
  write("v.hlsl",
        "float4 main(uint i : SV_VertexID) : SV_Position {\n"
        "  return float4(i == 1u ? 3.0 : -1.0, i == 2u ? 3.0 : -1.0, 0.5, 1.0);\n}\n");
  write("f.hlsl",
        "Texture2D inputs : register(t0);\n"
        "float4 main(float4 place : SV_Position) : SV_Target {\n"
        "  return inputs.Load(int3(int(place.y) * 64 + int(place.x), 0, 0));\n}\n");
  compile("v.hlsl", "vert", flags("1"));
  compile("f.hlsl", "frag", flags("1"));
  std::vector<float> inputs(4096 * 4);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = float(i) / 3;
  write("inputs.bin", bytes_of(inputs));
  const Json j = Json::parse(R"({"api": "vulkan", "width": 64, "height": 64, "textures": [
    {"binding": 1, "file": "inputs.bin", "width": 4096, "height": 1, "filter": "nearest"}],
    "draws": [{"vertex": "v.hlsl.spv", "fragment": "f.hlsl.spv", "output": "o.bin"}]})");
  ASSERT_TRUE(run_job(j).succeeded());
  EXPECT_EQ(read_file(path("o.bin"), "o.bin"), bytes_of(inputs));
}

}  // namespace
}  // namespace lumaknot::gpu
