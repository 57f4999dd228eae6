// isolux help [TOPIC]: the pages of the documentation.
#include <fstream>
#include <iostream>

#include "app/commands/command.h"
#include "app/files/documentation.h"
#include "base/error.h"

namespace isolux::app {

Command makeHelp(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("help", "Print a page of the documentation, or list the pages");
  auto topic = std::make_shared<std::string>();
  parser->add_option("TOPIC", *topic,
                     "The page, for example slices or reference/formats; without it all are listed");
  parser->footer("Examples:\n  isolux help\n  isolux help slices");
  return {parser, [topic](base::Progress&) {
            const std::vector<DocumentationPage> pages = documentationPages(documentationFolder());
            if (pages.empty()) base::throwInput("share/doc/isolux", "", "the documentation is not installed");
            if (topic->empty())
              for (const DocumentationPage& page : pages) printRow(std::cout, page.name, page.title, 36);
            else
              std::cout << std::ifstream(documentationPage(pages, *topic).file).rdbuf();
          }};
}

}  // namespace isolux::app
