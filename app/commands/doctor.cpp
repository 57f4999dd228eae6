// isolux doctor
#include <iostream>

#include "app/commands/command.h"
#include "app/report/machine_report.h"

namespace isolux::app {

Command makeDoctor(CLI::App& program, const std::function<std::string()>& describeWindow) {
  CLI::App* const parser =
      program.add_subcommand("doctor", "Print graphics contexts, memory and libraries of this computer");
  parser->footer("Example:\n  isolux doctor");
  return {parser, [describeWindow](base::Progress& progress) {
            printDoctor(std::cout, describeWindow ? describeWindow() : std::string(), progress);
          }};
}

}  // namespace isolux::app
