#include "shaders/graph/blender_nodes.h"

#include <gtest/gtest.h>

#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/graph/blender_machine.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

using Json = BlenderJson;

Json nodes_of(const View& view, const Shot& shot) {
  return blender_nodes(record_shot(view, shot).color);
}

/// Calls `check(shot, shader)` for every shot's nodes under all kinds of light.
template <class F>
void for_each_shader(F check) {
  const View view = every_view().back().view;
  for (const Shot& shot : every_shot()) check(shot, nodes_of(view, shot));
}

TEST(BlenderNodes, compute_what_the_double_instance_computes) {
  RandomSurface random;
  for (const NamedView& view : every_view()) {
    for (const Shot& shot : every_shot()) {
      const Json shader = nodes_of(view.view, shot);
      const auto lighting = lighting_of<double>(view.view, shot.material);
      const SurfacePoint<double> point = random.point();
      const Vec3d texture = random.texture();
      const Vec3d expected =
          stage_color(point, texture_value(texture, shot.material), lighting, shot);
      const Vec3d found = run_blender_nodes(shader, surface_inputs(point, texture, shot.material));
      // The same operations; ln x / ln e rounds once more, times a chroma of 40 in DIN99.
      ASSERT_LT(largest_magnitude(found - expected),
                1e-13 * std::max(1.0, largest_magnitude(expected)))
          << view.name << ": " << shot.name;
    }
  }
}

TEST(BlenderNodes, every_socket_reads_a_constant_or_an_earlier_node) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (std::size_t i = 0; i < shader["nodes"].size(); ++i) {
      const Json sockets = shader["nodes"][i].value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        ASSERT_EQ(source.size(), 1u) << shot.name;
        if (source.contains("node")) {
          ASSERT_LT(source["node"].get<std::size_t>(), i) << shot.name << " " << name;
        } else {
          ASSERT_TRUE(source.contains("const")) << shot.name << " " << name;
        }
      }
    }
  });
}

TEST(BlenderNodes, use_only_nodes_and_sockets_that_blender_has) {
  const std::set<std::string> vector{"Vector"}, components{"X", "Y", "Z"};
  for_each_shader([&](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      if (!node.contains("type")) continue;
      std::set<std::string> sockets;
      for (const auto& [name, source] : node["sockets"].items()) sockets.insert(name);
      if (node["type"] == "ShaderNodeSeparateXYZ") {
        ASSERT_EQ(sockets, vector) << shot.name;
        ASSERT_TRUE(components.contains(node["output"])) << shot.name;
        continue;
      }
      ASSERT_TRUE(known_blender_nodes().contains(blender_kind(node)))
          << shot.name << " " << blender_kind(node);
      const BlenderNode& known = known_blender_nodes().at(blender_kind(node));
      ASSERT_EQ(sockets, known.sockets) << shot.name << " " << blender_kind(node);
      ASSERT_EQ(node["output"], known.output) << shot.name << " " << blender_kind(node);
    }
  });
}

TEST(BlenderNodes, output_is_the_last_node_and_every_other_is_read) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    std::set<std::size_t> read{shader["output"].get<std::size_t>()};
    for (const Json& node : shader["nodes"]) {
      const Json sockets = node.value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        if (source.contains("node")) read.insert(source["node"].get<std::size_t>());
      }
    }
    EXPECT_EQ(shader["output"], shader["nodes"].size() - 1) << shot.name;
    EXPECT_EQ(read.size(), shader["nodes"].size()) << shot.name;
  });
}

TEST(BlenderNodes, numbers_without_a_name_are_written_into_sockets) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      if (node.contains("type") || node.contains("input")) continue;
      EXPECT_NE(node.value("label", ""), "") << shot.name;  // a parameter of the scene
    }
  });
}

TEST(BlenderNodes, constants_have_the_shape_of_their_sockets) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      const Json sockets = node.value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        if (!source.contains("const")) continue;
        ASSERT_EQ(source["const"].is_array(), name.starts_with("Vector")) << shot.name;
      }
    }
  });
}

TEST(BlenderNodes, the_texture_stage_is_one_node) {
  const Shot shot{"t", Stage::kTexture, {}};
  EXPECT_EQ(nodes_of(View{}, shot),
            (Json{{"nodes", Json::array({Json{{"input", "texture"}}})}, {"output", 0}}));
}

TEST(BlenderNodes, of_one_constant_are_one_node_of_that_colour) {
  View dark;
  dark.lights = {};
  const Json shader = nodes_of(dark, {"d", Stage::kDiffuse, {}});
  EXPECT_EQ(shader["nodes"].size(), 1u);
  EXPECT_EQ(run_blender_nodes(shader, {}), Vec3d{});
}

TEST(BlenderNodes, labels_tell_the_formula_s_names) {
  Shot shot;
  shot.material.space = Space::kYiq;
  std::multiset<std::string> labels;
  const Json shader = nodes_of(View{}, shot);
  for (const Json& node : shader["nodes"]) labels.insert(node.value("label", ""));
  for (const char* name : {"to_eye", "to_light", "n", "n_dot_l", "reflection", "light", "highlight",
                           "y", "i", "q", "lit_brightness", "shininess", "ambient"}) {
    EXPECT_EQ(labels.count(name), 1u) << name;
  }
}

TEST(BlenderNodes, a_choice_takes_one_side_exactly) {
  const Scalar a = scalar_input("a");
  const ScalarVec choice = grey(select_less(a, Scalar(0.5), Scalar(0.1), Scalar(0.7)));
  const Json shader = blender_nodes(choice.node);
  for (const double value : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(run_blender_nodes(shader, {{"a", {value, 0, 0}}}), grey(value < 0.5 ? 0.1 : 0.7));
  }
}

TEST(BlenderNodes, are_the_same_bytes_each_time) {
  const View view = every_view().back().view;
  for_each_shader([&](const Shot& shot, const Json& shader) {
    ASSERT_EQ(nodes_of(view, shot).dump(), shader.dump()) << shot.name;
  });
}

}  // namespace
}  // namespace lumaknot
