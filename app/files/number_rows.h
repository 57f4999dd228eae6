// Rows of numbers: of text files (CSV), and of options.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::app {

struct NumberRow {
  std::vector<double> numbers;
  std::size_t line = 0;  // of the file, from 1
};

// Rows of exactly `columns` finite numbers, separated by commas, semicolons, tabs or spaces, also quoted.
// Empty lines and those that begin with # are left out; so is the first one where it has no number (names of
// columns). Throws Error{input} naming file and line.
std::vector<NumberRow> readNumberRows(const std::filesystem::path& file, std::size_t columns);

// "x,y,z x,y,z ...": between `fewest` and `most` points. Throws Error{usage} naming the option.
std::vector<glm::dvec3> parsePoints(const std::string& text, const std::string& option, std::size_t fewest,
                                    std::size_t most);

}  // namespace isolux::app
