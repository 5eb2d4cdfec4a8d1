/// Emitted shaders, read as text.
#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "scene/presets.h"
#include "shaders/languages/emit.h"

namespace lumaknot {

/// A job for a formula, one point light unless `lights` says otherwise.
inline ShaderJob emission_job(const std::string& formula, Keep keep = Keep::kAll,
                              const std::vector<Light>& lights = {PointLight{}}) {
  ShaderJob job;
  job.name = formula;
  job.view.lights = lights;
  job.shot = {"final", Stage::kFinal, *with_formula(Material{}, formula)};
  job.keep = keep;
  return job;
}

/// `text` without comments, annotations in quotes and preprocessor lines that include.
inline std::string code_of(const std::string& text) {
  static const std::regex kNoCode(R"(//[^\n]*|"[^"\n]*")");
  return std::regex_replace(text, kNoCode, "");
}

/// The words of a code and how often each occurs.
inline std::map<std::string, int> words_of(const std::string& code) {
  const auto is_letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  std::map<std::string, int> words;
  for (auto at = code.begin(); at != code.end();) {
    const auto begin = std::find_if(at, code.end(), is_letter);
    at = std::find_if_not(begin, code.end(), is_letter);
    const bool is_number = begin != at && std::isdigit(static_cast<unsigned char>(*begin));
    if (begin != at && !is_number) ++words[std::string(begin, at)];
  }
  return words;
}

/// The names that a code declares: "vec3 name =", "float name,", "#local Name =", ...; functions
/// are not among them.
inline std::set<std::string> declared_names(const std::string& code) {
  static const std::regex kDeclaration(
      R"(\b(?:float|vec[234]|float[234]|vector|mat4|float4x4|sampler2D|Texture2D|SamplerState|texture|#local)\s+(\w+)\s*(?=[=;,)\[:<]|$))");
  static const std::regex kLocal(R"(#local\s+(\w+))");
  std::set<std::string> names;
  for (const std::regex* pattern : {&kDeclaration, &kLocal}) {
    for (std::sregex_iterator it(code.begin(), code.end(), *pattern), end; it != end; ++it) {
      names.insert(it->str(1));
    }
  }
  return names;
}

/// The functions of a C-like code, each from its type to the bracket that closes it.
inline std::vector<std::string> functions_of(const std::string& code) {
  // The head alone is a pattern: one over the body too would recurse per character.
  static const std::regex kHead(R"((?:float|vec3|float3) \w+\([^)]*\) \{\n)");
  constexpr std::string_view kEnd = "\n}\n";
  std::vector<std::string> functions;
  for (std::sregex_iterator it(code.begin(), code.end(), kHead), end; it != end; ++it) {
    const auto begin = std::size_t(it->position());
    if (begin > 0 && code[begin - 1] != '\n') continue;
    const std::size_t close = code.find(kEnd, begin);
    if (close != code.npos) functions.push_back(code.substr(begin, close + kEnd.size() - begin));
  }
  return functions;
}

/// The shader's files, without parameters.json, as one text.
inline std::string emitted_text(const ShaderJob& job, Language language) {
  const Emission files = emit(job, language);
  std::string text;
  for (std::size_t i = 0; i + 1 < files.size(); ++i) text += files[i].text + "\n";
  return text;
}

inline std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

}  // namespace lumaknot
