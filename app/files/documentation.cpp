#include "app/files/documentation.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "base/error.h"
#include "base/words.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

std::string titleOf(const fs::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("# ")) return line.substr(2);
  return file.stem().string();
}

// "index" of a folder is the folder's own page.
std::string nameOf(const std::string& folder, const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem == "index" ? folder : folder + "/" + stem;
}

}  // namespace

fs::path documentationFolder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const char* const place : {"../../share/doc/isolux", "../../../docs"}) {
    fs::path folder = (program / place).lexically_normal();
    if (fs::exists(folder / "index.md", none)) return folder;
  }
  return {};
}

std::vector<DocumentationPage> documentationPages(const fs::path& folder) {
  std::vector<DocumentationPage> pages;
  if (folder.empty()) return pages;
  for (const std::string part : {"start", "guide", "howto", "reference", "explanation"}) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / part, none))
      if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) pages.push_back({nameOf(part, file), titleOf(file), file});
  }
  return pages;
}

DocumentationPage documentationPage(const std::vector<DocumentationPage>& pages, const std::string& topic) {
  std::vector<std::string> names;
  for (const DocumentationPage& page : pages) {
    if (page.name == topic || page.name.ends_with("/" + topic)) return page;
    names.push_back(page.name.substr(page.name.find('/') + 1));
  }
  const std::string near = base::nearest(topic, names);
  base::throwUsage(
      "", topic,
      "no such page; " + (near.empty() ? "`isolux help` lists the pages" : "did you mean " + near + "?"));
}

}  // namespace isolux::app
