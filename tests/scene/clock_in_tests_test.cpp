// Reads every test of the tree: none may be passed by a quick or quiet machine alone. An assertion must not
// hold what a clock says, or anything made from it, under a bound; what a program decides is counted instead
// (tests/README.md).
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Allowed {
  std::string_view file, assertion, because;
};

// Each must be needed.
constexpr std::array<Allowed, 10> allowed{{
    {"tests/support/stop_latency.cpp", "base::median(processor)",
     "processor time, half of it where none stops"},
    {"tests/ui/window/first_visit_test.cpp", "longestProcessor()",
     "processor time of a thread, room of four"},
    {"tests/ui/window/responsiveness_test.cpp", "longestProcessor()",
     "processor time of a thread, room of four"},
    {"tests/volume/field/coefficients_test.cpp", "filled, 20.0 * plain",
     "processor time, a ratio of 5 within one run, which was 60"},
    {"tests/volume/prepared/prepared_volume_test.cpp", "around.count()",
     "measured within what it is compared with"},
    {"tests/app/documents/autosave_test.cpp",
     "before <= ", "a time stamp between two of the test's own, however long it takes"},
    {"tests/app/documents/recording_test.cpp", "steps[0].seconds, 60.0", "a time stamp, and a minute"},
    {"tests/app/error_budget/target_job_gl_test.cpp", "expectedMilliseconds, 600000.0",
     "what was asked for: ten minutes"},
    {"tests/ui/viewport/animation_test.cpp", "0.5 * least", "ended before what it is compared with"},
    {"tests/ui/accuracy/target_box_test.cpp", "expectedMilliseconds, 100000.0", "what was asked for: 100 s"},
}};

struct Assertion {
  int line = 0;
  std::string kind;  // LT, GT, TRUE, ...
  std::vector<std::string> arguments;
};

std::string withoutComments(const std::string& content, bool python) {
  static const std::regex cpp(R"(//[^\n]*)"), py(R"(#[^\n]*)");
  return std::regex_replace(content, python ? py : cpp, "");
}

// From behind the opening parenthesis to its end, cut at commas; texts are left out.
std::vector<std::string> argumentsAt(const std::string& text, std::size_t at) {
  std::vector<std::string> arguments(1);
  for (int depth = 1; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
      arguments.back() += "\"\"";
      continue;
    }
    if (c == '(' || c == '[' || c == '{') ++depth;
    if ((c == ')' || c == ']' || c == '}') && --depth == 0) break;
    if (c == ',' && depth == 1)
      arguments.emplace_back();
    else if (!std::isspace(static_cast<unsigned char>(c)) || !arguments.back().ends_with(' '))
      arguments.back() += std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return arguments;
}

std::vector<Assertion> assertionsOf(const std::string& text) {
  static const std::regex call(
      R"((?:EXPECT|ASSERT)_(LT|LE|GT|GE|NEAR|TRUE|FALSE)\(|self\.assert(Less|LessEqual|Greater|GreaterEqual|AlmostEqual|True|False)\()");
  std::vector<Assertion> found;
  int line = 1;
  std::size_t counted = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), call), end; match != end; ++match) {
    const auto at = static_cast<std::size_t>(match->position());
    line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                        text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    found.push_back({line, (*match)[1].matched ? (*match)[1] : (*match)[2],
                     argumentsAt(text, at + static_cast<std::size_t>(match->length()))});
  }
  return found;
}

const std::regex& clockWords() {
  static const std::regex words(
      R"([Cc]lock::now|std::clock\(|[Ee]lapsed\(|[Ss]econdsSince|rocessorSeconds|rocessSeconds|[Ss]econds\b|[Mm]illiseconds\b|\bMs\b|monotonic\(|perf_counter\(|process_time\(|longest(Processor|Wall)|wallQuantile)");
  return words;
}

bool namesAny(const std::string& text, const std::set<std::string>& wanted) {
  static const std::regex word(R"([A-Za-z_]\w*)");
  for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match)
    if (wanted.contains(match->str())) return true;
  return false;
}

bool readsClock(const std::string& text) {
  static const std::regex reads(
      R"([Cc]lock::now\(|std::clock\(|[Ee]lapsed\(|[Ss]econdsSince|rocessorSeconds|rocessSeconds|monotonic\(|perf_counter\(|process_time\()");
  return std::regex_search(text, reads);
}

// Variables of a function that have got what a clock said, or what was made from such a variable, and
// `known`.
std::set<std::string> clockVariables(const std::string& function, std::set<std::string> known) {
  static const std::regex given(
      R"((\w+)(?:\s=\s|\.(?:push_back|emplace_back|append|insert)\()([^;\n]*(?:\n[^;\n]*){0,3}))");
  struct Given {
    std::string name, value;
  };
  std::vector<Given> all;
  for (std::sregex_iterator match(function.begin(), function.end(), given), end; match != end; ++match)
    all.push_back({(*match)[1], (*match)[2]});
  for (std::size_t before = known.size() + 1; before != known.size();) {
    before = known.size();
    for (const Given& one : all)
      if (readsClock(one.value) || namesAny(one.value, known)) known.insert(one.name);
  }
  return known;
}

// What must not be large for the assertion to hold.
std::string boundedPart(const Assertion& assertion) {
  const std::vector<std::string>& of = assertion.arguments;
  const std::string& kind = assertion.kind;
  if (kind == "LT" || kind == "LE" || kind == "Less" || kind == "LessEqual") return of[0];
  if (kind == "GT" || kind == "GE" || kind == "Greater" || kind == "GreaterEqual")
    return of.size() > 1 ? of[1] : "";
  if (kind == "NEAR" || kind == "AlmostEqual") return of[0] + ' ' + (of.size() > 1 ? of[1] : "");
  static const std::regex compares(R"([^-<]<=?[^<]|[^->]>=?[^>])");
  const bool waits =
      of[0].find("pollUntil") != std::string::npos || of[0].find("waitUntil") != std::string::npos;
  return !waits && std::regex_search(of[0], compares) ? of[0] : "";
}

// Functions, whose variables are their own: up to a brace at the beginning of a line, or the next method.
std::vector<std::string> functionsOf(const std::string& text, bool python) {
  const std::string_view end = python ? "\n    def " : "\n}";
  std::vector<std::string> functions;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t next = std::min(text.find(end, begin + 1), text.size());
    functions.push_back(text.substr(begin, next - begin));
    begin = next;
  }
  return functions;
}

// Names of those that return what a clock says.
std::set<std::string> measuringFunctions(const std::vector<std::string>& functions) {
  static const std::regex head(R"((?:^|\n)(?:static )?double (\w+)\()");
  std::set<std::string> found;
  for (const std::string& function : functions)
    if (std::smatch match; readsClock(function) && std::regex_search(function, match, head))
      found.insert(match[1]);
  return found;
}

// One line for each assertion of a test's source that holds a clock under a bound.
std::vector<std::string> clocksIn(const std::string& path, const std::string& content,
                                  std::set<std::string>* needed = nullptr) {
  static const std::regex constant(R"(std::chrono::\w+\([0-9']*\))");
  const bool python = path.ends_with(".py");
  std::vector<std::string> found;
  int line = 1;
  const std::vector<std::string> functions = functionsOf(withoutComments(content, python), python);
  const std::set<std::string> measuring = measuringFunctions(functions);
  for (const std::string& function : functions) {
    const std::vector<Assertion> assertions = assertionsOf(function);
    const std::set<std::string> variables =
        assertions.empty() ? std::set<std::string>() : clockVariables(function, measuring);
    for (const Assertion& assertion : assertions) {
      const std::string part = std::regex_replace(boundedPart(assertion), constant, "");
      if (!std::regex_search(part, clockWords()) && !namesAny(part, variables)) continue;
      std::string whole;
      for (const std::string& argument : assertion.arguments) whole += (whole.empty() ? "" : ",") + argument;
      const auto known = std::find_if(allowed.begin(), allowed.end(), [&](const Allowed& one) {
        return path == one.file && whole.find(one.assertion) != std::string::npos;
      });
      if (known == allowed.end())
        found.push_back(path + ':' + std::to_string(line + assertion.line - 1) + ": " + assertion.kind + '(' +
                        whole + ')');
      else if (needed)
        needed->insert(std::string(known->file));
    }
    line += static_cast<int>(std::count(function.begin(), function.end(), '\n'));
  }
  return found;
}

TEST(ClockInTests, NoAssertionHoldsOneUnderABound) {
  const fs::path root(ISOLUX_SOURCE_DIR);
  int files = 0;
  std::set<std::string> needed;
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
    const std::string extension = entry.path().extension().string();
    if (!entry.is_regular_file() || (extension != ".cpp" && extension != ".h" && extension != ".py"))
      continue;
    const std::string path = fs::relative(entry.path(), root).generic_string();
    if (path == "tests/scene/clock_in_tests_test.cpp") continue;
    std::stringstream content;
    content << std::ifstream(entry.path()).rdbuf();
    EXPECT_THAT(clocksIn(path, content.str(), &needed), IsEmpty());
    ++files;
  }
  EXPECT_GT(files, 300) << "the test does not look where the tests are";
  for (const Allowed& one : allowed)
    EXPECT_TRUE(needed.contains(std::string(one.file))) << one.file << " needs no exception any more";
}

TEST(ClockInTests, FindsEachKind) {
  for (const char* text :
       {"EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));",
        "ASSERT_LE(timer.elapsed(), 100);", "EXPECT_GT(0.1, secondsSince(begin));",
        "EXPECT_TRUE(Clock::now() - begin < limit);", "EXPECT_NEAR(job.milliseconds(), 20.0, 5.0);",
        "const auto begin = Clock::now();\nconst double took = (Clock::now() - begin).count();\n"
        "times.push_back(took);\nconst double p95 = percentile(times, 0.95);\nEXPECT_LE(p95, 100.0);",
        "const double a = processorSeconds(f);\nEXPECT_LT(other,\n          2.0 * 3.0);EXPECT_LT(a, b);",
        "double tookMs() {\n  return count(Clock::now());\n}\n\nTEST(A, B) {\n  EXPECT_LT(tookMs(), "
        "3.0);\n}\n",
        "double best = 1e9;\nbest =\n    std::min(best, count(Clock::now() - begin));\nEXPECT_LT(best, "
        "10.0);",
        "EXPECT_LE(watchdog.wallQuantile(0.95), 30.0);"})
    EXPECT_THAT(clocksIn("a_test.cpp", text), ElementsAre(HasSubstr("a_test.cpp:"))) << text;
  EXPECT_THAT(clocksIn("a_test.cpp", "int a;\n\nEXPECT_LT(t.elapsed(), 3);"),
              ElementsAre("a_test.cpp:3: LT(t.elapsed(), 3)"));
  EXPECT_THAT(clocksIn("a_test.py", "sent = time.monotonic()\nself.assertLess(time.monotonic() - sent, 1)"),
              ElementsAre(HasSubstr("a_test.py:2: Less")));
}

TEST(ClockInTests, AcceptsLowerBoundsWaitsAndWhatIsNoClock) {
  for (const char* text :
       {"EXPECT_GE(first - start, std::chrono::milliseconds(250));  // const auto first = Clock::now();",
        "EXPECT_GT(report.milliseconds, 0.0);", "EXPECT_TRUE(pollUntil([&] { return seconds() > 1.0; }));",
        "EXPECT_LT(calls, 3);  // seconds", "EXPECT_EQ(clock.seconds(), 2.0);",
        "EXPECT_LT(a.second, b.second);", "EXPECT_LT(stop, \"seconds\");", "EXPECT_TRUE(watch->seconds());"})
    EXPECT_THAT(clocksIn("a_test.cpp", text), IsEmpty()) << text;
}

}  // namespace
}  // namespace isolux
