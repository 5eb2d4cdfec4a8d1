/// A language that shaders are emitted to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shaders/graph/shader.h"
#include "shaders/languages/code_printer.h"
#include "shaders/languages/list.h"

namespace lumaknot {

#define LUMAKNOT_LANGUAGE(name) k##name,
enum class Language { LUMAKNOT_LANGUAGES(LUMAKNOT_LANGUAGE) };
#undef LUMAKNOT_LANGUAGE

/// All of them, in the order of their values.
std::span<const Language> languages();

/// A file of an emission; `name` has no folder.
struct EmittedFile {
  std::string name;
  std::string text;
};

/// A stand-alone fragment shader; see emit_kernel().
struct KernelCode {
  std::string vertex, fragment;  ///< HLSL: the same text, entries vertex_main and fragment_main
};

/// All that is particular to a language.
struct Backend {
  std::string_view name;   ///< on the command line
  std::string_view about;  ///< what runs it
  const Dialect* dialect;  ///< how it spells formulas
  /// The files of a shader that the language can express; parameters.json is added to them.
  std::vector<EmittedFile> (*emit)(const Shader& shader);
  bool has_vertex_stage = false;
  bool has_block = false;     ///< parameters lie in a block, at the offsets of parameter_block()
  std::string_view api = {};  ///< of lumaknot-gpu, which runs it: gl, gles, vulkan; else empty
  /// Why it can't express `shader`, and the nearest that it can; null where it can express all.
  std::optional<std::string> (*shortfall)(const Shader& shader) = nullptr;
  /// Null where the language has no programs of its own.
  KernelCode (*kernel)(const Shader& shader) = nullptr;
};

const Backend& backend_of(Language language);

inline const Dialect& dialect_of(Language language) { return *backend_of(language).dialect; }

/// The language called `name`, or nothing.
std::optional<Language> language_of(std::string_view name);

/// Why `language` can't express the material's formula, and the nearest that it can; empty if it
/// can.
std::optional<std::string> language_shortfall(Language language, const Material& material);

}  // namespace lumaknot
