#include "app/commands/made_pages.h"

#include <algorithm>
#include <map>
#include <sstream>

#include <CLI/CLI.hpp>

#include "base/words.h"
#include "render/graph/frame.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

std::string replaced(const std::string& text, const std::map<char, std::string>& replacements) {
  std::string result;
  for (const char c : text) {
    const auto found = replacements.find(c);
    result += found == replacements.end() ? std::string(1, c) : found->second;
  }
  return result;
}

// Those that are meant to be seen.
std::vector<const CLI::Option*> optionsOf(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

// Text that roff leaves as it is: one line, whatever it begins with.
std::string escaped(const std::string& text) {
  const std::string result =
      replaced(text, {{'\\', "\\e"}, {'-', "\\-"}});  // a minus that can be copied, not a hyphen
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string inQuotes(const std::string& text) {  // as one argument of a macro
  return '"' + replaced(escaped(text), {{'"', "\\(dq"}}) + '"';
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
  return std::ranges::any_of(options, [&](const CLI::Option* other) {
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

// All options of `app` but those that `common` has, too; returns the latter's names.
std::vector<std::string> writeOptions(std::ostream& out, const CLI::App& app, const CLI::App* common) {
  std::vector<std::string> left;
  for (const CLI::Option* option : optionsOf(app)) {
    if (common && !option->get_positional() && hasOption(*common, *option))
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
  if (!common.empty()) out << ".PP\nAs above: " << escaped(base::joined(common)) << ".\n";
  out << ".PP\n" << asTyped(command.get_footer());
}

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

// ---- Markdown

std::string plainName(const CLI::Option& option) {
  const CLI::Formatter help;
  std::string name = help.make_option_name(&option, option.get_positional());
  if (!option.get_type_name().empty()) name += ' ' + option.get_type_name();
  return name;
}

// The options but those of `common`; a line tells of these.
void writeList(std::ostream& out, const CLI::App& app, const CLI::App* common) {
  std::string items;
  bool left = false;
  for (const CLI::Option* option : optionsOf(app)) {
    if (option->get_name() == "--help") continue;
    if (common && !option->get_positional() && hasOption(*common, *option))
      left = true;
    else
      items += "- `" + plainName(*option) + "`: " + option->get_description() + '\n';
  }
  if (!items.empty()) out << '\n' << items;
  if (left)
    out << "\nIt also takes [common options](#common-options) (`isolux " << app.get_name() << " --help`).\n";
}

std::string examplesOf(const CLI::App& command) {
  std::istringstream in(command.get_footer());
  std::string examples;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("  isolux")) examples += line.substr(2) + '\n';
  return examples;
}

std::string commandsPage(const CLI::App& program) {
  std::ostringstream out;
  out << "# Commands\n\n"
         "Generated by `isolux --made-page commands`; a test compares. `isolux COMMAND --help` prints the "
         "same.\n"
         "Keys of JSON output, AOVs and exit codes: [outputs](outputs.md).\n\n"
         "## Common options\n\n"
         "`isolux [OPTIONS] [PATH]` opens the window; a command takes those of these options that it "
         "needs.\n";
  writeList(out, program, nullptr);
  for (const CLI::App* command : program.get_subcommands({})) {
    out << "\n## " << command->get_name() << "\n\n" << command->get_description() << ".\n";
    writeList(out, *command, &program);
    if (const std::string examples = examplesOf(*command); !examples.empty())
      out << "\n```sh\n" << examples << "```\n";
  }
  return out.str();
}

std::string aovsTable() {
  std::string text = "| AOV | channels | unit |\n|---|---|---|\n";
  for (const render::AovInfo& aov : render::aovs()) {
    std::string channels;
    for (const std::string channel : aov.channels)
      channels += (channels.empty() ? "`" : ", `") + std::string(aov.name) +
                  (channel.empty() ? "" : "." + channel) + '`';
    text += "| `" + std::string(aov.name) + "` | " + channels + " | " + replaced(aov.unit, {{'|', "\\|"}}) +
            " |\n";
  }
  return text;
}

// ---- Completions

std::string longNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : optionsOf(app))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return base::joined(names, " ");
}

std::string commandNames(const CLI::App& program, const char* separator) {
  return base::joined(program.get_subcommands({}), separator,
                      [](const CLI::App* command) { return command->get_name(); });
}

// In single quotes of a shell, on one line.
std::string quoted(const std::string& text) {
  return "'" + replaced(text, {{'\'', "'\\''"}, {'\n', " "}}) + "'";
}

std::string bashCompletion(const CLI::App& program) {
  std::ostringstream out;
  out << "# bash completion for isolux, made by `isolux --made-page bash`\n_isolux() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= word\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n    case $word in "
      << commandNames(program, "|")
      << ") command=$word; break ;; esac\n  done\n"
         "  if [ \"$before\" = --set ]; then\n    compopt -o nospace\n    COMPREPLY=($(compgen -W '"
      << base::joined(scene::settings(), " ", [](const scene::Setting& s) { return s.path + "="; })
      << "' -- \"$current\"))\n    return\n  fi\n  local options\n  case $command in\n";
  for (const CLI::App* command : program.get_subcommands({}))
    out << "    " << command->get_name() << ") options='" << longNames(*command) << "' ;;\n";
  out << "    *) options='" << longNames(program) << "' ;;\n  esac\n"
      << "  if [[ $current == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
      << "  elif [ -z \"$command\" ] && [ \"$COMP_CWORD\" = 1 ]; then\n    COMPREPLY=($(compgen -W '"
      << commandNames(program, " ") << "' -- \"$current\") $(compgen -f -- \"$current\"))\n  fi\n}\n"
      << "complete -o default -o bashdefault -F _isolux isolux\n";
  return out.str();
}

// `[` and `]` end a description, `:` a part of a specification.
std::string zshText(const std::string& text) {
  return replaced(text, {{'[', "\\["}, {']', "\\]"}, {':', "\\:"}, {'\\', "\\\\"}});
}

void writeZshArguments(std::ostream& out, const CLI::App& app, const char* indent) {
  for (const CLI::Option* option : optionsOf(app)) {
    const std::string value =
        option->get_items_expected_max() > 0 ? ":" + zshText(option->get_type_name()) + ":_files" : "";
    for (const std::string& name : option->get_lnames())
      out << indent << quoted("*--" + name + "[" + zshText(option->get_description()) + "]" + value)
          << " \\\n";
  }
}

std::string zshCompletion(const CLI::App& program) {
  std::ostringstream out;
  out << "#compdef isolux\n# made by `isolux --made-page zsh`\nlocal -a commands=(\n";
  for (const CLI::App* command : program.get_subcommands({}))
    out << "  " << quoted(zshText(command->get_name()) + ":" + zshText(command->get_description())) << '\n';
  out << ")\nif (( CURRENT == 2 )); then\n  _describe command commands\n  _files\n  return\nfi\ncase "
         "$words[2] in\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    out << "  " << command->get_name() << ")\n    _arguments \\\n";
    writeZshArguments(out, *command, "      ");
    out << "      '*:file:_files' ;;\n";
  }
  out << "  *)\n    _arguments \\\n";
  writeZshArguments(out, program, "      ");
  out << "      '*:file:_files' ;;\nesac\n";
  return out.str();
}

std::string fishCompletion(const CLI::App& program) {
  std::ostringstream out;
  out << "# made by `isolux --made-page fish`\n";
  const auto options = [&](const CLI::App& app, const std::string& condition) {
    for (const CLI::Option* option : optionsOf(app))
      for (const std::string& name : option->get_lnames())
        out << "complete -c isolux -n " << quoted(condition) << " -l " << name
            << (option->get_items_expected_max() > 0 ? " -r" : "") << " -d "
            << quoted(option->get_description()) << '\n';
  };
  for (const CLI::App* command : program.get_subcommands({}))
    out << "complete -c isolux -n __fish_use_subcommand -a " << command->get_name() << " -d "
        << quoted(command->get_description()) << '\n';
  options(program, "__fish_use_subcommand");
  for (const CLI::App* command : program.get_subcommands({}))
    options(*command, "__fish_seen_subcommand_from " + command->get_name());
  return out.str();
}

}  // namespace

std::vector<std::string> madePageNames() {
  return {"man", "commands", "aovs", "bash", "zsh", "fish"};
}

std::string madePage(const std::string& name, const CLI::App& program, const std::string& version) {
  if (name == "man") return manPage(program, version);
  if (name == "commands") return commandsPage(program);
  if (name == "aovs") return aovsTable();
  if (name == "bash") return bashCompletion(program);
  return name == "zsh" ? zshCompletion(program) : fishCompletion(program);
}

}  // namespace isolux::app
