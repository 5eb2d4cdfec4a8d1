/// Runs an emitted POV-Ray macro on rows of numbers.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/vec.h"
#include "shaders/languages/common.h"
#include "system/atomic_file.h"
#include "system/process.h"

namespace lumaknot::testing {

/// One input of a macro, by its name in the formula: a value for each row, a scalar in x.
struct PovInput {
  std::string name;
  bool is_vector = true;
  std::vector<Vec3d> values;
};

/// The parameters of `macro`, as `include` defines it.
inline std::vector<std::string> pov_parameters(const std::string& include,
                                               const std::string& macro) {
  const std::string head = "#macro " + macro + "(";
  const std::size_t begin = include.find(head);
  if (begin == include.npos) throw std::runtime_error("no macro " + macro);
  const std::size_t end = include.find(')', begin);
  std::string list = include.substr(begin + head.size(), end - begin - head.size());
  std::ranges::replace(list, ',', ' ');
  std::istringstream stream(list);
  std::vector<std::string> names;
  for (std::string name; stream >> name;) names.push_back(name);
  return names;
}

/// The input for the macro's `parameter`; "texture" is also the one for a texture on axes.
inline const PovInput& pov_input(const std::vector<PovInput>& inputs,
                                 const std::string& parameter) {
  for (const PovInput& input : inputs) {
    const std::string baked = input.name == "texture" ? "texture_axes" : input.name;
    if (identifier_of(input.name, dialect_of(Language::kPov)) == parameter ||
        identifier_of(baked, dialect_of(Language::kPov)) == parameter) {
      return input;
    }
  }
  throw std::runtime_error("no input for " + parameter);
}

/// A scene that calls `macro` for every row and writes the colours to "colors".
inline std::string pov_calls(const std::string& include, const std::string& macro,
                             const std::vector<PovInput>& inputs, std::size_t rows) {
  std::vector<const PovInput*> arguments;
  for (const std::string& parameter : pov_parameters(include, macro)) {
    arguments.push_back(&pov_input(inputs, parameter));
  }
  std::string text =
      "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#include \"macro.inc\"\n"
      "#fopen Out \"colors\" write\n"
      "#macro Row(Color) #write(Out, vstr(3, Color, \" \", 0, 17), \"\\n\") #end\n";
  for (std::size_t row = 0; row < rows; ++row) {
    std::string call;
    for (const PovInput* argument : arguments) {
      const Vec3d& v = argument->values.at(row);
      if (!call.empty()) call += ", ";
      call +=
          argument->is_vector ? fmt::format("<{}, {}, {}>", v.x, v.y, v.z) : fmt::format("{}", v.x);
    }
    text += fmt::format("Row({}({}))\n", macro, call);
  }
  return text + "#fclose Out\n";
}

/// The results of `macro`, defined by the text `include`, for each of the `rows` rows of `inputs`;
/// inputs that it does not take are ignored. Throws std::runtime_error if POV-Ray is missing or
/// fails.
inline std::vector<Vec3d> run_pov_macro(const std::string& include, const std::string& macro,
                                        const std::vector<PovInput>& inputs, std::size_t rows) {
  const std::string program = find_program("povray").string();
  if (program.empty())
    throw std::runtime_error("povray not found; install with apt-get install povray");
  const PrivateFolder folder;
  write_file(folder.path() / "macro.inc", include, "kernel");
  write_file(folder.path() / "rows.pov", pov_calls(include, macro, inputs, rows), "kernel");
  write_file(folder.path() / "empty.ini", "; in place of the user's\n", "kernel");
  const ProcessResult ended = run({{program, "+Irows.pov", "-F", "-D", "+W1", "+H1", "+WT1"},
                                   folder.path(),
                                   {"POVINI=empty.ini"}},
                                  std::chrono::seconds(120));
  if (!ended.succeeded()) throw std::runtime_error(ended.log);
  std::istringstream stream(read_file(folder.path() / "colors", "kernel"));
  std::vector<Vec3d> colors;
  std::array<std::string, 3> v;
  while (stream >> v[0] >> v[1] >> v[2]) {
    colors.push_back({std::strtod(v[0].c_str(), nullptr), std::strtod(v[1].c_str(), nullptr),
                      std::strtod(v[2].c_str(), nullptr)});
  }
  if (colors.size() != rows) throw std::runtime_error("POV-Ray wrote too few colours");
  return colors;
}

}  // namespace lumaknot::testing
