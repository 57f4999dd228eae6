#include "volume/read/zarr/json_fields.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/chunks/chunked_array.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

void JsonField::refuse(const std::string& reason) const {
  base::throwInput(file_, place_, reason);
}

bool JsonField::has(const char* key) const {
  if (!value_->is_object()) return false;
  const auto found = value_->find(key);
  return found != value_->end() && !found->is_null();
}

JsonField JsonField::at(const char* key) const {
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (!value_->is_object()) refuse("is not an object");
  const auto found = value_->find(key);
  if (found == value_->end()) base::throwInput(file_, place, "is missing");
  return {*found, file_, place};
}

std::vector<JsonField> JsonField::entries() const {
  if (!value_->is_array()) refuse("is not a list");
  constexpr std::size_t most = 10000;
  if (value_->size() > most) refuse("is a list of more than " + std::to_string(most) + " entries");
  std::vector<JsonField> fields;
  for (std::size_t i = 0; i < value_->size(); ++i)
    fields.emplace_back((*value_)[i], file_, place_ + "[" + std::to_string(i) + "]");
  return fields;
}

std::string JsonField::text() const {
  if (!value_->is_string()) refuse("is not text");
  return value_->get<std::string>();
}

double JsonField::number() const {
  if (value_->is_boolean()) return value_->get<bool>() ? 1.0 : 0.0;
  if (value_->is_number()) return value_->get<double>();
  if (value_->is_string()) {
    const auto& word = value_->get_ref<const std::string&>();
    if (word == "NaN") return std::numeric_limits<double>::quiet_NaN();
    if (word == "Infinity") return std::numeric_limits<double>::infinity();
    if (word == "-Infinity") return -std::numeric_limits<double>::infinity();
  }
  refuse("is not a number");
}

std::vector<double> JsonField::numbers(std::size_t count) const {
  const std::vector<JsonField> fields = entries();
  if (fields.size() != count)
    refuse("has " + std::to_string(fields.size()) + " numbers; the axes are " + std::to_string(count));
  std::vector<double> values;
  for (const JsonField& field : fields) values.push_back(field.number());
  return values;
}

std::vector<std::uint64_t> JsonField::counts() const {
  const std::vector<JsonField> fields = entries();
  if (fields.empty() || fields.size() > kMostArrayAxes)
    refuse("has " + std::to_string(fields.size()) + " axes; 1 to " + std::to_string(kMostArrayAxes) +
           " are read");
  std::vector<std::uint64_t> values;
  for (const JsonField& field : fields) {
    if (!field.value().is_number_unsigned() || field.value().get<std::uint64_t>() == 0)
      field.refuse("must be a whole number of at least 1");
    values.push_back(field.value().get<std::uint64_t>());
  }
  return values;
}

namespace {

// Python writes the bare words NaN, Infinity and -Infinity, which JSON does not have: put in quotes, as
// JsonField::number() knows them. `quoted`: where, in the new text.
std::string withQuotedNumbers(const std::string& text, std::vector<std::size_t>& quoted) {
  std::string out;
  bool inText = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    std::size_t length = 0;
    for (const std::string_view word : {"NaN", "Infinity", "-Infinity"})
      if (!inText && rest.starts_with(word)) length = word.size();
    if (length > 0) {
      quoted.push_back(out.size());
      out.append("\"").append(rest.substr(0, length)).append("\"");
      at += length;
      continue;
    }
    if (inText && text[at] == '\\' && at + 1 < text.size()) {
      out += text[at++];
      out += text[at++];
      continue;
    }
    if (text[at] == '"') inText = !inText;
    out += text[at++];
  }
  return out;
}

// Tells keys that stand twice in one object; JSON leaves open which counts.
class KeyWatch {
 public:
  bool operator()(int, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(value.get<std::string>()).second)
      twice_.insert(value.get<std::string>());
    return true;
  }
  const std::set<std::string>& twice() const { return twice_; }

 private:
  std::vector<std::set<std::string>> keys_;
  std::set<std::string> twice_;
};

}  // namespace

nlohmann::json parseJson(const std::string& text, const std::string& file,
                         std::vector<std::string>* warnings) {
  std::vector<std::size_t> quoted;
  const std::string plain = withQuotedNumbers(text, quoted);
  try {
    KeyWatch watch;
    nlohmann::json json = nlohmann::json::parse(plain, std::ref(watch));
    if (!json.is_object()) base::throwInput(file, "", "is not a JSON object");
    if (warnings)
      for (const std::string& key : watch.twice())
        warnings->push_back("the key " + inQuotes(key) + " occurs twice in " +
                            std::filesystem::path(file).filename().string() + "; the last one counts");
    return json;
  } catch (const nlohmann::json::parse_error& error) {
    std::size_t byte = error.byte;
    for (const std::size_t at : quoted) byte -= at < error.byte ? 2 : 0;
    base::throwInput(file, "byte " + std::to_string(byte), "is not JSON");
  } catch (const nlohmann::json::exception& error) {
    base::throwInput(file, "", std::string("cannot be used: ") + error.what());
  }
}

}  // namespace isolux::volume
