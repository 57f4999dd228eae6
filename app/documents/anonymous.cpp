#include "app/documents/anonymous.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "base/words.h"

namespace isolux::app {

namespace {

struct Hidden {
  std::string text;  // small letters
  bool wholeWords;
};

// Letters beyond ASCII are bytes above 127 here, and parts of words.
bool isWordPart(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 128 || std::isalnum(byte) != 0;
}

std::vector<Hidden> hiddenOf(const volume::Patient& patient) {
  std::vector<Hidden> hidden;
  std::string word;
  for (const char letter : base::lowerCase(patient.name) + ' ') {
    if (isWordPart(letter)) {
      word += letter;
      continue;
    }
    if (word.size() >= 2) hidden.push_back({word, word.size() < 4});
    word.clear();
  }
  if (patient.id.size() >= 3) hidden.push_back({base::lowerCase(patient.id), false});
  if (const std::string& d = patient.birthDate; d.size() == 8) {
    const std::string year = d.substr(0, 4), month = d.substr(4, 2), day = d.substr(6, 2);
    std::string pointed = day;
    pointed.append(".").append(month).append(".").append(year);
    std::string dashed = year;
    dashed.append("-").append(month).append("-").append(day);
    for (const std::string& written : {d, dashed, pointed}) hidden.push_back({written, false});
  }
  // The longest first: an id that holds the name is hidden as a whole.
  std::ranges::stable_sort(hidden,
                           [](const Hidden& a, const Hidden& b) { return a.text.size() > b.text.size(); });
  return hidden;
}

bool standsAt(const std::string& text, std::size_t at, const Hidden& hidden) {
  if (text.compare(at, hidden.text.size(), hidden.text) != 0) return false;
  if (!hidden.wholeWords) return true;
  const std::size_t end = at + hidden.text.size();
  return (at == 0 || !isWordPart(text[at - 1])) && (end == text.size() || !isWordPart(text[end]));
}

// "anonymous^anonymous" and "anonymous, anonymous" are one.
std::string mergedWords(std::string text) {
  const std::string_view word = kAnonymous;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;) {
    const std::size_t end = at + word.size();
    const std::size_t next = text.find(word, end);
    const std::string_view between = std::string_view(text).substr(end, next - end);
    if (next != std::string::npos && between.find_first_not_of(" ^_,-.") == std::string_view::npos)
      text.erase(end, next + word.size() - end);
    else
      at = end;
  }
  return text;
}

}  // namespace

std::string withoutPatient(const std::string& text, const volume::Patient& patient) {
  const std::vector<Hidden> hidden = hiddenOf(patient);
  const std::string searched = base::lowerCase(text);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto found =
        std::ranges::find_if(hidden, [&](const Hidden& one) { return standsAt(searched, at, one); });
    if (found == hidden.end()) {
      result += text[at++];
    } else {
      result += kAnonymous;
      at += found->text.size();
    }
  }
  return result == text ? text : mergedWords(result);
}

scene::Scene withoutPatient(scene::Scene scene, const volume::Patient& patient) {
  const auto hide = [&patient](auto& named) { named.name = withoutPatient(named.name, patient); };
  std::ranges::for_each(scene.surfaces, hide);
  std::ranges::for_each(scene.marks, hide);
  std::ranges::for_each(scene.lamps, hide);
  return scene;
}

}  // namespace isolux::app
