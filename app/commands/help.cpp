// isolux help [TOPIC]: the pages of the documentation.
#include <fstream>
#include <iostream>

#include "app/commands/command.h"
#include "app/files/documentation.h"
#include "base/error.h"

namespace isolux::app {

namespace {

void listPages(const std::vector<DocumentationPage>& pages, std::ostream& out) {
  constexpr std::size_t column = 36;
  for (const DocumentationPage& page : pages)
    out << page.name << std::string(column - std::min(column - 1, page.name.size()), ' ') << page.title
        << '\n';
}

}  // namespace

Command makeHelp(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("help", "Print a page of the documentation, or list the pages");
  auto topic = std::make_shared<std::string>();
  parser->add_option("TOPIC", *topic,
                     "The page, for example slices or reference/formats; without it all are listed");
  parser->footer("Examples:\n  isolux help\n  isolux help slices");
  return {parser, [topic](base::Progress&) {
            const std::vector<DocumentationPage> pages = documentationPages(documentationFolder());
            if (pages.empty())
              throw base::Error(base::ErrorKind::input, "share/doc/isolux", "",
                                "the documentation is not installed");
            if (topic->empty()) return listPages(pages, std::cout);
            std::cout << std::ifstream(documentationPage(pages, *topic).file).rdbuf();
          }};
}

}  // namespace isolux::app
