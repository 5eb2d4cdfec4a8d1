/// The languages that shaders are emitted to.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "scene/shot.h"

namespace lumaknot {

enum class Language { kGlsl330, kGlslEs300, kGlsl450, kHlsl, kFx, kOsl, kBlender, kPov };

/// A language as the command line and the documentation name it.
struct LanguageInfo {
  Language language;
  std::string_view name;
  std::string_view about;
  bool has_vertex_stage;
};

inline constexpr std::array<LanguageInfo, 8> kLanguages{{
    {Language::kGlsl330, "glsl-330", "OpenGL 3.3 core", true},
    {Language::kGlslEs300, "glsl-es-300", "OpenGL ES 3.0 and WebGL 2", true},
    {Language::kGlsl450, "glsl-450", "Vulkan", true},
    {Language::kHlsl, "hlsl", "Direct3D 11 and 12, shader model 5 and 6", true},
    {Language::kFx, "fx", "Direct3D 9 effect as in the paper's Table 1, FX Composer", true},
    {Language::kOsl, "osl", "Open Shading Language, for an emission", false},
    {Language::kBlender, "blender", "Blender 3.4 to 5.x, a node group", false},
    {Language::kPov, "pov", "POV-Ray 3.7, an include file with a macro", false},
}};

const LanguageInfo& info_of(Language language);

/// The language called `name`, or nothing.
std::optional<Language> language_of(std::string_view name);

/// What keeps `language` from expressing the material's formula and the nearest thing that works,
/// or nothing when it can.
std::optional<std::string> language_shortfall(Language language, const Material& material);

}  // namespace lumaknot
