#include "exporters/blender/scene.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "exporters/image/file.h"
#include "shaders/formulas/lighting.h"
#include "tests/exporters/testing.h"

namespace lumaknot::blender {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::names;
using ::testing::Not;
using testing::small_scene;
using ::testing::UnorderedElementsAre;

std::vector<Shot> shots() {
  return {{"texture", Stage::kTexture, testing::material("phong")},
          {"diffuse", Stage::kDiffuse, testing::material("yiq-table1")},
          {"specular", Stage::kSpecular, testing::material("phong")},
          {"final", Stage::kFinal, testing::material("yiq-table1")}};
}

const std::string& script(const Package& package) { return package.back().bytes; }

json parameters(const Package& package) {
  const std::string& text = script(package);
  const std::size_t begin = text.find("r'''") + 4, end = text.find("'''", begin);
  return json::parse(text.substr(begin, end - begin));
}

/// The exit status of `program` run with `arguments`, found on the path, without a shell.
int run(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (::posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Python's own parser on the package's script.
bool is_python(const Package& package) {
  const testing::TemporaryFolder folder;
  const auto path = folder.file("script.py", script(package));
  return run({"python3", "-c", "import ast, sys; ast.parse(open(sys.argv[1], 'rb').read())",
              path.string()}) == 0;
}

/// The values of type T in `bytes` from `offset` on.
template <class T>
std::vector<T> values(const std::string& bytes, std::size_t offset, std::size_t count) {
  std::vector<T> result(count);
  std::memcpy(result.data(), bytes.data() + offset, count * sizeof(T));
  return result;
}

TEST(BlenderPackage, python_parses_the_script) {
  EXPECT_TRUE(is_python(blender_package(small_scene(), shots(), "knot")));
  EXPECT_TRUE(is_python(blender_package(small_scene(Vec3d{1, 0, 0}), {}, "n\xc5\x93ud {0} %s")));
}

TEST(BlenderPackage, python_would_notice_a_broken_script) {
  Package broken = blender_package(small_scene(), shots(), "knot");
  broken.back().bytes += "\n'''";  // Python reports it on the error output
  EXPECT_FALSE(is_python(broken));
}

TEST(BlenderPackage, files_are_the_mesh_the_texture_and_last_the_script) {
  EXPECT_THAT(names(blender_package(small_scene(), shots(), "k")),
              ElementsAre("k.mesh.bin", "k.texture.png", "k.py"));
  EXPECT_THAT(names(blender_package(small_scene(Vec3d{1, 0, 0}), shots(), "k")),
              ElementsAre("k.mesh.bin", "k.py"));
}

TEST(BlenderPackage, mesh_file_holds_the_mesh_in_float32) {
  const Scene scene = small_scene();
  const Package package = blender_package(scene, shots(), "k");
  const TriangleMesh& mesh = scene.mesh;
  const std::size_t n = mesh.positions.size(), t = mesh.triangles.size();
  const std::string& bytes = package[0].bytes;
  ASSERT_EQ(bytes.size(), n * 8 * 4 + t * 3 * 4);
  const auto positions = values<float>(bytes, 0, 3 * n);
  const auto normals = values<float>(bytes, 12 * n, 3 * n);
  const auto uvs = values<float>(bytes, 24 * n, 2 * n);
  const auto indices = values<std::int32_t>(bytes, 32 * n, 3 * t);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d p = mesh.positions[i], m = mesh.normals[i];
    EXPECT_EQ(positions[3 * i], float(p.x));
    EXPECT_EQ(positions[3 * i + 1], float(p.y));
    EXPECT_EQ(positions[3 * i + 2], float(p.z));
    EXPECT_EQ(normals[3 * i], float(m.x));
    EXPECT_EQ(normals[3 * i + 1], float(m.y));
    EXPECT_EQ(normals[3 * i + 2], float(m.z));
    EXPECT_EQ(uvs[2 * i], float(mesh.uvs[i].u));
    EXPECT_EQ(uvs[2 * i + 1], float(mesh.uvs[i].v));
  }
  for (std::size_t i = 0; i < 3 * t; ++i) {
    EXPECT_EQ(std::uint32_t(indices[i]), mesh.triangles[i / 3][i % 3]);
  }
}

TEST(BlenderPackage, parameters_count_what_the_mesh_file_holds) {
  const Package package = blender_package(small_scene(), shots(), "k");
  const json mesh = parameters(package)["mesh"];
  EXPECT_EQ(mesh["file"], "k.mesh.bin");
  const auto vertices = mesh["vertices"].get<std::size_t>();
  const auto triangles = mesh["triangles"].get<std::size_t>();
  EXPECT_EQ(package[0].bytes.size(), vertices * 8 * 4 + triangles * 3 * 4);
  EXPECT_EQ(vertices, 25u * 7u);
  EXPECT_EQ(triangles, 2u * 24u * 6u);
}

TEST(BlenderPackage, parameters_give_the_camera_exactly) {
  Scene scene = small_scene();
  scene.view.camera = {.position = {1, -4, 1.0 / 3}, .target = {0.5, 0, 0}, .fov_degrees = 50};
  scene.view.image = {300, 200, 1};
  const json p = parameters(blender_package(scene, shots(), "k"));
  const json& camera = p["camera"];
  const auto vector = [&](const char* key) {
    return Vec3d{camera[key][0], camera[key][1], camera[key][2]};
  };
  EXPECT_EQ(vector("position"), scene.view.camera.position);
  EXPECT_EQ(camera["fov_y_degrees"], 50);
  EXPECT_EQ(p["image"]["width"], 300);
  EXPECT_EQ(p["image"]["height"], 200);
  constexpr double kRounding = 1e-15;  // of unit vectors
  EXPECT_NEAR(length(cross(vector("right"), vector("up")) - vector("back")), 0, 4 * kRounding);
  EXPECT_NEAR(dot(vector("right"), vector("up")), 0, kRounding);
  const Vec3d sight = normalize(scene.view.camera.target - scene.view.camera.position);
  EXPECT_NEAR(dot(vector("back"), sight), -1, kRounding);
}

TEST(BlenderPackage, texture_is_a_file_or_a_color) {
  const Package with_image = blender_package(small_scene(), shots(), "k");
  EXPECT_EQ(parameters(with_image)["shots"][0]["texture"], json({{"file", "k.texture.png"}}));
  const testing::TemporaryFolder folder;
  EXPECT_EQ(read_texture(folder.file("t.png", with_image[1].bytes), "t").pixels,
            testing::small_texture().pixels);
  const Package plain = blender_package(small_scene(Vec3d{0.1, 0.5, 1}), shots(), "k");
  EXPECT_EQ(parameters(plain)["shots"][0]["texture"], json({{"color", {0.1, 0.5, 1.0}}}));
}

Shot baked(Space space, const std::string& name) {
  Shot shot{name, Stage::kFinal, Material{}};
  shot.material.space = space;
  shot.material.form = Form::kBaked;
  return shot;
}

/// The r, g and b of every pixel of an EXR file.
std::vector<float> exr_values(const std::string& bytes) {
  const testing::TemporaryFolder folder;
  const auto input = OIIO::ImageInput::open(folder.file("t.exr", bytes).string());
  if (!input || input->spec().nchannels != 3) return {};
  std::vector<float> values(input->spec().image_pixels() * 3);
  EXPECT_EQ(input->spec().format, OIIO::TypeFloat);
  EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeFloat, values.data()));
  return values;
}

TEST(BlenderPackage, baked_texture_is_a_float_image_of_the_axes) {
  const Shot shot = baked(Space::kYiq, "final");
  const Package package = blender_package(small_scene(), {&shot, 1}, "k");
  EXPECT_THAT(names(package), ElementsAre("k.mesh.bin", "k.yiq.axes.exr", "k.py"));
  const json entry = parameters(package)["shots"][0];
  EXPECT_EQ(entry["texture_axes"], json({{"file", "k.yiq.axes.exr"}}));
  EXPECT_FALSE(entry.contains("texture"));
  const std::vector<float> values = exr_values(package[1].bytes);
  const std::vector<Rgb>& texels = testing::small_texture().pixels;
  ASSERT_EQ(values.size(), 3 * texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const Vec3d axes = texture_value(to_vec(texels[i]), shot.material);
    EXPECT_EQ(values[3 * i], float(axes.x));
    EXPECT_EQ(values[3 * i + 1], float(axes.y));
    EXPECT_EQ(values[3 * i + 2], float(axes.z));
  }
  EXPECT_LT(*std::ranges::min_element(values), -0.1) << "chroma has a sign";
}

TEST(BlenderPackage, baked_color_keeps_its_sign) {
  const Shot shot = baked(Space::kYiq, "final");
  const Package package = blender_package(small_scene(Vec3d{0, 0, 1}), {&shot, 1}, "k");
  EXPECT_THAT(names(package), ElementsAre("k.mesh.bin", "k.py"));
  const json color = parameters(package)["shots"][0]["texture_axes"]["color"];
  const Vec3d axes = texture_value({0, 0, 1}, shot.material);
  EXPECT_EQ(color, json({axes.x, axes.y, axes.z}));
  EXPECT_LT(color[1], 0) << "blue has a negative I";
}

TEST(BlenderPackage, each_space_has_one_baked_texture) {
  const std::vector<Shot> list{baked(Space::kYiq, "a"), baked(Space::kYuv709, "b"),
                               baked(Space::kYiq, "c"), shots()[0]};
  const Package package = blender_package(small_scene(), list, "k");
  EXPECT_THAT(names(package), ElementsAre("k.mesh.bin", "k.yiq.axes.exr", "k.yuv709.axes.exr",
                                          "k.texture.png", "k.py"));
  EXPECT_NE(package[1].bytes, package[2].bytes);
  const json entries = parameters(package)["shots"];
  EXPECT_EQ(entries[0]["texture_axes"], entries[2]["texture_axes"]);
}

TEST(BlenderPackage, textures_that_no_shot_reads_are_left_out) {
  const std::vector<Shot> terms{shots()[1], shots()[2]};
  EXPECT_THAT(names(blender_package(small_scene(), terms, "k")), ElementsAre("k.mesh.bin", "k.py"));
}

TEST(BlenderPackage, light_at_vertices_is_refused_with_the_nearest_alternative) {
  Shot shot = shots()[3];
  shot.material.rate = ShadingFrequency::kVertex;
  for (const ShotShaders shaders : {ShotShaders::kNodes, ShotShaders::kOsl}) {
    const std::string error =
        error_of([&] { blender_package(small_scene(), {&shot, 1}, "k", shaders); });
    EXPECT_THAT(error, HasSubstr("material.rate is \"vertex\""));
    EXPECT_THAT(error, HasSubstr("nearest is rate \"pixel\""));
  }
}

TEST(BlenderPackage, in_osl_every_shot_has_its_shader_and_its_inputs) {
  const Package package = blender_package(small_scene(), shots(), "k", ShotShaders::kOsl);
  EXPECT_TRUE(is_python(package));
  const json list = parameters(package)["shots"];
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(list[i]["osl"], "k." + shots()[i].name + ".osl");
    const PackedFile* file = testing::find(package, list[i]["osl"].get<std::string>());
    ASSERT_TRUE(file);
    for (const auto& [ours, theirs] : list[i]["inputs"].items()) {
      EXPECT_THAT(file->bytes, HasSubstr("vector " + theirs.get<std::string>() + " =")) << ours;
    }
    EXPECT_FALSE(list[i].contains("nodes"));
  }
  const auto inputs = [&](std::size_t i) {
    std::vector<std::string> result;
    for (const auto& entry : list[i]["inputs"].items()) result.push_back(entry.key());
    return result;
  };
  EXPECT_THAT(inputs(0), UnorderedElementsAre("texture"));
  EXPECT_THAT(inputs(3), UnorderedElementsAre("position", "normal", "texture"));
}

TEST(BlenderPackage, every_shot_has_its_nodes_arguments_before_their_users) {
  const json list = parameters(blender_package(small_scene(), shots(), "k"))["shots"];
  ASSERT_EQ(list.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(list[i]["name"], shots()[i].name);
    EXPECT_FALSE(list[i]["nodes"].empty());
    EXPECT_LT(list[i]["output"].get<std::size_t>(), list[i]["nodes"].size());
  }
  EXPECT_GT(list[3]["nodes"].size(), list[0]["nodes"].size());
}

TEST(BlenderPackage, nothing_reveals_where_it_was_created) {
  for (const PackedFile& file : blender_package(small_scene(), shots(), "k")) {
    EXPECT_THAT(file.bytes, Not(HasSubstr(LUMAKNOT_SOURCE_DIR))) << file.name;
    EXPECT_THAT(file.bytes, Not(HasSubstr("/tmp/"))) << file.name;
    EXPECT_THAT(file.bytes, Not(HasSubstr("/home/"))) << file.name;
  }
}

TEST(BlenderPackage, gives_the_same_bytes_twice) {
  const Package a = blender_package(small_scene(), shots(), "k");
  const Package b = blender_package(small_scene(), shots(), "k");
  ASSERT_EQ(names(a), names(b));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].bytes, b[i].bytes) << a[i].name;
}

}  // namespace
}  // namespace lumaknot::blender
