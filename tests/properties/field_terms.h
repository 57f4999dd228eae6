// Random scalar fields from a small grammar, as trees that have a text:
//
//   add(scale:1e+06(const:1),clamp:-0.5:0.5(noise:17))
//
// A term is its name, its numbers and its operands. What each means: kTerms in field_terms.cpp.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::test {

struct FieldTerm {
  std::string name;
  std::vector<double> numbers;
  std::vector<FieldTerm> operands;

  // At voxel `at` of a volume of `dims` voxels; NaN and infinities are missing voxels.
  double operator()(glm::ivec3 at, glm::ivec3 dims) const;
  bool operator==(const FieldTerm&) const = default;
};

// At most `depth` operations one in another.
FieldTerm randomTerm(std::mt19937_64& random, int depth);
std::string textOf(const FieldTerm& term);
// Takes the term off the front of the text. Throws std::invalid_argument.
FieldTerm parseTerm(std::string_view& text);
// One step simpler, the simplest first: an operand instead of an operation, a constant instead of a leaf.
std::vector<FieldTerm> simplerTerms(const FieldTerm& term);

// Shortest decimal text that reads back as the same number.
std::string exactText(double value);

}  // namespace isolux::test
