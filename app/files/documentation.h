// Finds the pages of the documentation that come with the program, as Markdown files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isolux::app {

struct DocumentationPage {
  std::string name;   // "guide/slices"
  std::string title;  // its first heading
  std::filesystem::path file;
};

// Returns the folder that holds index.md: ../../share/doc/isolux of the program's own folder where it is
// installed, docs of the source tree where it was built; empty where there is neither.
std::filesystem::path documentationFolder();

// Returns the pages for users (start, guide, howto, reference, explanation), in that order, each folder's by
// name. Empty without a folder.
std::vector<DocumentationPage> documentationPages(const std::filesystem::path& folder);

// Returns the page `topic`: "guide/slices", or "slices" alone, the first of that name. Throws
// base::Error{usage} with a suggestion where there is none.
DocumentationPage documentationPage(const std::vector<DocumentationPage>& pages, const std::string& topic);

}  // namespace isolux::app
