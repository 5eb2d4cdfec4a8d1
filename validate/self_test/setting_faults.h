/// Faults in the settings of other renderers: what their programs read is altered on its way.
#pragma once

#include <string>
#include <vector>

#include "system/process.h"
#include "validate/renderers/programs.h"
#include "validate/self_test/faults.h"

namespace lumaknot::validate {

struct SettingFault {
  std::string renderer;        ///< flag
  const ProgramInfo* program;  ///< that reads the file
  std::string files;           ///< which: a pattern for find's -name
  std::string edit;            ///< a script for sed
  Fault fault;                 ///< what, and the causes that may be named
};

/// Those of the renderers with these flags.
std::vector<SettingFault> setting_faults(const std::vector<std::string>& renderers);

/// A stand-in for a program, which edits the files that it is given and then runs the program.
class AlteredProgram {
 public:
  AlteredProgram(const SettingFault& fault, Programs programs);
  const Programs& programs() const { return programs_; }

 private:
  PrivateFolder folder_;
  Programs programs_;
};

}  // namespace lumaknot::validate
