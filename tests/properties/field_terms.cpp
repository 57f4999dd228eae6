#include "tests/properties/field_terms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "base/random.h"

namespace isolux::test {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct Place {
  glm::ivec3 voxel, dims;

  // In [0, 1] along each axis.
  glm::dvec3 part() const { return glm::dvec3(voxel) / glm::dvec3(glm::max(dims - 1, glm::ivec3(1))); }
  // In [0, 1), of a block of 2^`shift` voxels per axis.
  double random(double seed, int shift = 0) const {
    const glm::ivec3 at(voxel.x >> shift, voxel.y >> shift, voxel.z >> shift);
    return base::uniformNoise(static_cast<std::uint64_t>(seed),
                              static_cast<std::uint64_t>((at.z * 64 + at.y) * 64 + at.x));
  }
};

using Numbers = std::vector<double>;
using Operands = std::vector<double>;

struct TermKind {
  const char* name;
  std::size_t numbers, operands;
  double (*value)(const Place&, const Numbers&, const Operands&);
  Numbers (*draw)(std::mt19937_64&);
};

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double seed(std::mt19937_64& random) {
  return static_cast<double>(random() % 1000000);
}
// Few digits: kept cases are read by people.
double rounded(double value) {
  return std::round(value * 64.0) / 64.0;
}

// Leaves first.
const std::array kTerms{
    TermKind{"const", 1, 0, [](const Place&, const Numbers& n, const Operands&) { return n[0]; },
             [](std::mt19937_64& r) { return Numbers{rounded(uniform(r, -2, 2))}; }},
    // White noise in [-1, 1].
    TermKind{"noise", 1, 0,
             [](const Place& p, const Numbers& n, const Operands&) { return 2.0 * p.random(n[0]) - 1.0; },
             [](std::mt19937_64& r) { return Numbers{seed(r)}; }},
    // White noise of a few integers.
    TermKind{
        "steps", 2, 0,
        [](const Place& p, const Numbers& n, const Operands&) { return std::floor(p.random(n[0]) * n[1]); },
        [](std::mt19937_64& r) {
          return Numbers{seed(r), static_cast<double>(2 + r() % 4)};
        }},
    TermKind{
        "ramp", 3, 0,
        [](const Place& p, const Numbers& n, const Operands&) {
          return glm::dot(p.part(), glm::dvec3(n[0], n[1], n[2]));
        },
        [](std::mt19937_64& r) {
          return Numbers{rounded(uniform(r, -2, 2)), rounded(uniform(r, -2, 2)), rounded(uniform(r, -2, 2))};
        }},
    TermKind{
        "waves", 3, 0,
        [](const Place& p, const Numbers& n, const Operands&) {
          const glm::dvec3 at(p.voxel);
          return std::sin(n[0] * at.x) * std::cos(n[1] * at.y) + std::sin(n[1] * at.z + n[2]);
        },
        [](std::mt19937_64& r) {
          return Numbers{rounded(uniform(r, 0.1, 2)), rounded(uniform(r, 0.1, 2)), rounded(uniform(r, 0, 6))};
        }},
    // 1 between two places along an axis, else 0.
    TermKind{"plateau", 3, 0,
             [](const Place& p, const Numbers& n, const Operands&) {
               const double at = p.part()[static_cast<int>(n[0])];
               return at >= n[1] && at <= n[2] ? 1.0 : 0.0;
             },
             [](std::mt19937_64& r) {
               return Numbers{static_cast<double>(r() % 3), rounded(uniform(r, 0, 0.5)),
                              rounded(uniform(r, 0.5, 1))};
             }},
    TermKind{"checkers", 1, 0,
             [](const Place& p, const Numbers& n, const Operands&) {
               const glm::ivec3 at = p.voxel / static_cast<int>(n[0]);
               return (at.x + at.y + at.z) % 2 == 0 ? 1.0 : -1.0;
             },
             [](std::mt19937_64& r) { return Numbers{static_cast<double>(1 + r() % 3)}; }},
    // 1 in single voxels, else 0.
    TermKind{
        "needles", 2, 0,
        [](const Place& p, const Numbers& n, const Operands&) { return p.random(n[0]) < n[1] ? 1.0 : 0.0; },
        [](std::mt19937_64& r) {
          return Numbers{seed(r), rounded(uniform(r, 0.02, 0.2))};
        }},
    TermKind{"ball", 4, 0,
             [](const Place& p, const Numbers& n, const Operands&) {
               return n[3] - glm::distance(p.part(), glm::dvec3(n[0], n[1], n[2]));
             },
             [](std::mt19937_64& r) {
               return Numbers{rounded(uniform(r, 0, 1)), rounded(uniform(r, 0, 1)), rounded(uniform(r, 0, 1)),
                              rounded(uniform(r, 0.1, 0.7))};
             }},
    // Missing voxels in clouds of 2^3, else 0.
    TermKind{"gaps", 2, 0,
             [](const Place& p, const Numbers& n, const Operands&) {
               return p.random(n[0], 1) < n[1] ? (p.random(n[0]) < 0.2 ? HUGE_VAL : kMissing) : 0.0;
             },
             [](std::mt19937_64& r) {
               return Numbers{seed(r), rounded(uniform(r, 0.02, 0.3))};
             }},
    TermKind{"add", 0, 2, [](const Place&, const Numbers&, const Operands& o) { return o[0] + o[1]; },
             [](std::mt19937_64&) { return Numbers{}; }},
    TermKind{"mul", 0, 2, [](const Place&, const Numbers&, const Operands& o) { return o[0] * o[1]; },
             [](std::mt19937_64&) { return Numbers{}; }},
    TermKind{"least", 0, 2,
             [](const Place&, const Numbers&, const Operands& o) {
               return std::isnan(o[0]) || o[0] < o[1] ? o[0] : o[1];
             },
             [](std::mt19937_64&) { return Numbers{}; }},
    TermKind{"abs", 0, 1, [](const Place&, const Numbers&, const Operands& o) { return std::fabs(o[0]); },
             [](std::mt19937_64&) { return Numbers{}; }},
    TermKind{"clamp", 2, 1,
             [](const Place&, const Numbers& n, const Operands& o) {
               return std::isnan(o[0]) ? o[0] : std::clamp(o[0], n[0], n[1]);
             },
             [](std::mt19937_64& r) {
               return Numbers{rounded(uniform(r, -1, 0)), rounded(uniform(r, 0, 1))};
             }},
    TermKind{"scale", 1, 1, [](const Place&, const Numbers& n, const Operands& o) { return n[0] * o[0]; },
             [](std::mt19937_64& r) {
               constexpr double factors[] = {-1.0, 0.125, 1e6, 1e-6, 1e-20, 1e20};
               return Numbers{factors[r() % std::size(factors)]};
             }},
};
constexpr std::size_t kLeaves = 10;

const TermKind& kindOf(std::string_view name) {
  const auto at =
      std::find_if(kTerms.begin(), kTerms.end(), [&](const TermKind& kind) { return name == kind.name; });
  if (at == kTerms.end()) throw std::invalid_argument("no term \"" + std::string(name) + '"');
  return *at;
}

double parseNumber(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) throw std::invalid_argument("no number at \"" + std::string(text) + '"');
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool takeOff(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::string exactText(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

double FieldTerm::operator()(glm::ivec3 at, glm::ivec3 dims) const {
  Operands values;
  for (const FieldTerm& operand : operands) values.push_back(operand(at, dims));
  return kindOf(name).value({at, dims}, numbers, values);
}

FieldTerm randomTerm(std::mt19937_64& random, int depth) {
  const bool leaf = depth == 0 || random() % 5 == 0;
  const TermKind& kind = kTerms[leaf ? random() % kLeaves : kLeaves + random() % (kTerms.size() - kLeaves)];
  FieldTerm term{kind.name, kind.draw(random), {}};
  while (term.operands.size() < kind.operands) term.operands.push_back(randomTerm(random, depth - 1));
  return term;
}

std::string textOf(const FieldTerm& term) {
  std::string text = term.name;
  for (const double number : term.numbers) text += ':' + exactText(number);
  for (std::size_t i = 0; i < term.operands.size(); ++i)
    text += (i == 0 ? '(' : ',') + textOf(term.operands[i]);
  return term.operands.empty() ? text : text + ')';
}

FieldTerm parseTerm(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(":(,) "), text.size());
  FieldTerm term{std::string(text.substr(0, end)), {}, {}};
  text.remove_prefix(end);
  while (takeOff(text, ':')) term.numbers.push_back(parseNumber(text));
  if (takeOff(text, '(')) {
    do term.operands.push_back(parseTerm(text));
    while (takeOff(text, ','));
    if (!takeOff(text, ')')) throw std::invalid_argument("\")\" is missing at \"" + std::string(text) + '"');
  }
  const TermKind& kind = kindOf(term.name);
  if (term.numbers.size() != kind.numbers || term.operands.size() != kind.operands)
    throw std::invalid_argument("\"" + term.name + "\" has other numbers or operands");
  return term;
}

std::vector<FieldTerm> simplerTerms(const FieldTerm& term) {
  std::vector<FieldTerm> simpler = term.operands;
  if (term.operands.empty() && term.name != "const") simpler.push_back({"const", {1.0}, {}});
  if (term.name == "const" && term.numbers[0] != 0.0 && term.numbers[0] != 1.0)
    simpler.push_back({"const", {1.0}, {}});
  if (term.name == "const" && term.numbers[0] == 1.0) simpler.push_back({"const", {0.0}, {}});
  for (std::size_t i = 0; i < term.operands.size(); ++i)
    for (FieldTerm& operand : simplerTerms(term.operands[i])) {
      simpler.push_back(term);
      simpler.back().operands[i] = std::move(operand);
    }
  return simpler;
}

}  // namespace isolux::test
