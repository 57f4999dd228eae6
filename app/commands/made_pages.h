// Makes the pages and files that repeat what the parser and the program's lists say: the manual page, the
// reference pages of commands and AOVs, and completions for shells.
//
// The build and the tests print them by `isolux --made-page NAME`, which --help does not show.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isolux::app {

// Returns the names of the pages: "man", "commands", "aovs", "bash", "zsh", "fish".
std::vector<std::string> madePageNames();

// Returns the page of that name. Requires a name of madePageNames().
std::string madePage(const std::string& name, const CLI::App& program, const std::string& version);

}  // namespace isolux::app
