#include "app/browser/series_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/number_text.h"
#include "base/words.h"

namespace isolux::app {

namespace {

std::string searchedText(const volume::DicomSeries& s, bool hidden) {
  std::string text;
  const auto add = [&](const std::string& part) { text += part + '\n'; };
  for (const std::string& part :
       {s.studyDescription, dateText(s.studyDate), s.studyDate, s.description, dateText(s.date), s.date,
        s.modality, s.kernel, s.number, sizeText(s), spacingText(s), slicesText(s)})
    add(part);
  for (const std::string& warning : shortWarnings(s)) add(warning);
  if (hidden) {
    add("anonymous");
  } else {
    for (const std::string& part : {s.patient.name, personText(s.patient.name), s.patient.id,
                                    s.patient.birthDate, dateText(s.patient.birthDate)})
      add(part);
  }
  return base::lowerCase(text);
}

}  // namespace

std::string personText(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char letter : name) {
    if (letter == '^')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  std::string text = parts.front();
  const char* between = ", ";
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].empty()) continue;
    text += (text.empty() ? "" : between) + parts[i];
    between = " ";
  }
  return text;
}

std::string dateText(const std::string& date) {
  const bool digits = std::ranges::all_of(date, [](char c) { return c >= '0' && c <= '9'; });
  if (date.size() != 8 || !digits) return date;
  return date.substr(0, 4) + '-' + date.substr(4, 2) + '-' + date.substr(6, 2);
}

std::string sizeText(const volume::DicomSeries& series) {
  if (series.columns < 1) return {};
  return std::to_string(series.columns) + " × " + std::to_string(series.rows);
}

std::string spacingText(const volume::DicomSeries& series) {
  const glm::dvec3 mm = series.spacingMm;
  if (!(mm.x > 0.0)) return {};
  const auto number = [](double value) { return base::shortText(value, 3); };
  return number(mm.x) + " × " + number(mm.y) + " × " + number(mm.z) + " mm";
}

std::string slicesText(const volume::DicomSeries& series) {
  const std::string slices = std::to_string(series.slices);
  return series.timeSteps > 1 ? std::to_string(series.timeSteps) + " × " + slices : slices;
}

std::string titleOf(const volume::DicomSeries& series) {
  if (!series.description.empty()) return series.description;
  return series.number.empty() ? "series" : "series " + series.number;
}

std::vector<std::string> shortWarnings(const volume::DicomSeries& series) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 17> known{{
      {"gantry tilt", "gantry tilt"},
      {"slices are missing", "missing slices"},
      {"slice distance changes", "uneven spacing"},
      {"slice distances are uneven", "uneven spacing"},
      {"no slice has a position", "no positions"},
      {"slices differ from the rest", "mixed slices"},
      {"repeat the position", "repeated slices"},
      {"are copies of others", "copies"},
      {"the time steps differ in", "several kinds of image"},
      {"slices of one time step differ", "mixed kinds of image"},
      {"instance numbers", "uncertain time steps"},
      {"belong to no complete time step", "incomplete time steps"},
      {"SpacingBetweenSlices", "uncertain spacing"},
      {"frames have one position", "uncertain spacing"},
      {"secondary capture", "secondary capture"},
      {"MONOCHROME1", "inverted grey"},
      {"LossyImageCompression", "lossy"},
  }};
  std::vector<std::string> words;
  const auto add = [&](std::string word) {
    if (std::ranges::find(words, word) == words.end()) words.push_back(std::move(word));
  };
  if (!series.problem.empty()) add("cannot be opened");
  for (const std::string& warning : series.warnings) {
    const auto found = std::ranges::find_if(
        known, [&](const auto& entry) { return warning.find(entry.first) != std::string::npos; });
    add(found == known.end() ? warning : std::string(found->second));
  }
  return words;
}

bool matches(const volume::DicomSeries& series, std::string_view search, bool hidden) {
  const std::string text = searchedText(series, hidden);
  const std::string wanted = base::lowerCase(std::string(search));
  for (std::size_t begin = 0; begin < wanted.size();) {
    const std::size_t end = std::min(wanted.find(' ', begin), wanted.size());
    if (text.find(wanted.substr(begin, end - begin)) == std::string::npos) return false;
    begin = end + 1;
  }
  return true;
}

}  // namespace isolux::app
