#include "app/commands/man_page.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>

namespace isolux::app {

namespace {

// Text that roff leaves as it is: one line, whatever it begins with.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";  // a minus that can be copied, not a hyphen
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string inQuotes(const std::string& text) {  // as one argument of a macro
  std::string result;
  for (const char c : escaped(text)) result += c == '"' ? "\\(dq" : std::string(1, c);
  return '"' + result + '"';
}

// The lines as they stand: usage, examples.
std::string asTyped(const std::string& lines) {
  std::istringstream in(lines);
  std::string result = ".nf\n";
  for (std::string line; std::getline(in, line);) result += escaped(line) + '\n';
  return result + ".fi\n";
}

bool hasOption(const CLI::App& app, const CLI::Option& option) {
  const auto options = app.get_options();
  return std::any_of(options.begin(), options.end(), [&](const CLI::Option* other) {
    return other->get_name() == option.get_name() && other->get_description() == option.get_description();
  });
}

void writeOption(std::ostream& out, const CLI::Option& option) {
  const CLI::Formatter help;
  const bool positional = option.get_positional();
  out << ".TP\n.B " << inQuotes(help.make_option_name(&option, positional) + help.make_option_opts(&option))
      << '\n'
      << escaped(option.get_description()) << '\n';
}

// All options of `app` that are meant to be seen, but those that `common` has, too; returns the latter's
// names.
std::vector<std::string> writeOptions(std::ostream& out, const CLI::App& app, const CLI::App* common) {
  std::vector<std::string> left;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    const bool isPath = option->get_positional();
    if (common && !isPath && hasOption(*common, *option))
      left.push_back(option->get_name());
    else
      writeOption(out, *option);
  }
  return left;
}

void writeCommand(std::ostream& out, const CLI::App& command, const CLI::App& program) {
  out << ".SS " << inQuotes("isolux " + command.get_name()) << '\n'
      << escaped(command.get_description()) << ".\n";
  std::ostringstream options;
  const std::vector<std::string> common = writeOptions(options, command, &program);
  out << options.str();
  if (!common.empty()) {
    std::string names;
    for (const std::string& name : common) names += (names.empty() ? "" : ", ") + name;
    out << ".PP\nAs above: " << escaped(names) << ".\n";
  }
  out << ".PP\n" << asTyped(command.get_footer());
}

}  // namespace

std::string manPage(const CLI::App& program, const std::string& version) {
  std::ostringstream out;
  out << ".TH ISOLUX 1 \"\" " << inQuotes("isolux " + version) << " \"User Commands\"\n.nh\n.ad l\n"
      << ".SH NAME\nisolux \\- explore scans and simulations as isosurfaces\n"
      << ".SH SYNOPSIS\n.B isolux\n[OPTIONS] [PATH]\n.br\n.B isolux\nCOMMAND [OPTIONS] ...\n"
      << ".SH DESCRIPTION\n"
      << escaped(program.get_description()) << '\n'
      << "Without a command it opens the window; commands need no display.\n"
      << ".SH OPTIONS\n";
  writeOptions(out, program, nullptr);
  out << ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({})) writeCommand(out, *command, program);
  out << ".SH NOTES\n" << asTyped(program.get_footer());
  return out.str();
}

}  // namespace isolux::app
