#include "cli/describe/man_page.h"

#include <fmt/format.h>

#include "cli/command_table.h"
#include "cli/describe/help.h"
#include "system/version.h"

namespace lumaknot::cli {
namespace {

/// `text` escaped for roff: dashes stay ASCII, and no line is a request.
std::string roff(std::string_view text) {
  std::string all = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    switch (c) {
      case '\\':
        all += "\\e";
        break;
      case '-':
        all += "\\-";
        break;
      case '\'':
        all += "\\(aq";
        break;
      case '\n':
        all += "\n.br\n";
        break;
      default:
        all += c;
    }
  }
  return all;
}

std::string upper(std::string_view text) {
  std::string all(text);
  for (char& c : all) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  return all;
}

/// Without a date, so that the output is reproducible.
std::string head(std::string_view name, std::string_view about) {
  return fmt::format(
      ".TH {} 1 \"\" \"lumaknot {}\" \"User Commands\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n",
      roff(upper(name)), version(), roff(name), roff(about));
}

std::string entry(const std::string& term, const std::string& text) {
  return fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(term), roff(text));
}

std::string option_sections(const Subcommand& command) {
  std::string text;
  for (const auto& [heading, arguments] : sections(command)) {
    const bool main = heading == "Arguments" || heading == "Options";
    text += fmt::format("{} \"{}\"\n", main ? ".SH" : ".SS",
                        roff(main ? upper(heading) : std::string(heading)));
    for (const Argument& argument : arguments) text += entry(label(argument), explained(argument));
  }
  return text;
}

std::string examples(const Subcommand& command) {
  std::string text = ".SH EXAMPLES\n";
  for (const Example& example : command.examples) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(example.line), roff(example.meaning));
  }
  return text;
}

std::string notes(const Subcommand& command) {
  return command.notes.empty() ? "" : fmt::format(".SH NOTES\n{}\n", roff(command.notes));
}

std::string page_name(const Subcommand& command) {
  return fmt::format("lumaknot-{}", command.name);
}

}  // namespace

std::string program_page(const Subcommand& program, std::span<const Subcommand> commands) {
  std::string text = head("lumaknot", program.about);
  text += ".SH SYNOPSIS\n\\fBlumaknot\\fR COMMAND [OPTIONS]\n.SH COMMANDS\n";
  std::string pages;
  for (const auto& [group, title] : kGroups) {
    text += fmt::format(".SS \"{}\"\n", title);
    for (const Subcommand& command : commands) {
      if (command.group != group) continue;
      text += entry(std::string(command.name), std::string(command.about));
      pages += fmt::format("{}.BR {} (1)", pages.empty() ? "" : ",\n", roff(page_name(command)));
    }
  }
  text += option_sections(program) + examples(program) + notes(program);
  return fmt::format("{}.SH \"SEE ALSO\"\n{}\n", text, pages);
}

std::string command_page(const Subcommand& command) {
  std::string text = head(page_name(command), command.about);
  text += fmt::format(".SH SYNOPSIS\n\\fB{}\\fR\n", roff(usage(command)));
  text += option_sections(command) + examples(command) + notes(command);
  return text + ".SH \"SEE ALSO\"\n.BR lumaknot (1)\n";
}

}  // namespace lumaknot::cli
