#include "volume/bricks/zarr/json_fields.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/bricks/chunks/chunked_array.h"

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
  if (!value_->is_object()) refuse("is no object");
  const auto found = value_->find(key);
  if (found == value_->end()) base::throwInput(file_, place, "is missing");
  return {*found, file_, place};
}

std::vector<JsonField> JsonField::entries() const {
  if (!value_->is_array()) refuse("is no list");
  constexpr std::size_t most = 10000;
  if (value_->size() > most) refuse("is a list of more than " + std::to_string(most) + " entries");
  std::vector<JsonField> fields;
  for (std::size_t i = 0; i < value_->size(); ++i)
    fields.emplace_back((*value_)[i], file_, place_ + "[" + std::to_string(i) + "]");
  return fields;
}

std::string JsonField::text() const {
  if (!value_->is_string()) refuse("is no text");
  return value_->get<std::string>();
}

std::string JsonField::text(const char* key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
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
  refuse("is no number");
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

nlohmann::json parseJson(const std::string& text, const std::string& file) {
  try {
    nlohmann::json json = nlohmann::json::parse(text);
    if (!json.is_object()) base::throwInput(file, "", "is no JSON object");
    return json;
  } catch (const nlohmann::json::parse_error& error) {
    base::throwInput(file, "byte " + std::to_string(error.byte), "is no JSON");
  } catch (const nlohmann::json::exception& error) {
    base::throwInput(file, "", std::string("cannot be used: ") + error.what());
  }
}

}  // namespace isolux::volume
