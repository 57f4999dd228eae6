// The notes of a volume's reader, the gravest first.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace isolux::app {

struct ImportNotes {
  std::vector<std::string> notes;
  std::size_t grave =
      0;  // so many, at the front, tell of data that are missing, made up or of uncertain place
};

// By the words that readers use: tests/app/documents/import_notes_test.cpp has an example of each.
ImportNotes importNotes(std::span<const std::string> warnings);

}  // namespace isolux::app
