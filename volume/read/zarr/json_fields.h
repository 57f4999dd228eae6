// Strict looks into JSON metadata: each throws base::Error{input} naming file and field where a value is
// missing, of another kind or out of range.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace isolux::volume {

// A value and what it is called in messages.
class JsonField {
 public:
  JsonField(const nlohmann::json& value, std::string file, std::string place)
      : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

  const nlohmann::json& value() const { return *value_; }
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }

  bool has(const char* key) const;  // and it is not null
  JsonField at(const char* key) const;
  std::vector<JsonField> entries() const;
  std::string text() const;
  std::string text(const char* key, const std::string& otherwise) const {
    return has(key) ? at(key).text() : otherwise;
  }
  double number() const;  // any number, also "NaN", "Infinity", "-Infinity"
  std::vector<double> numbers(std::size_t count) const;
  std::vector<std::uint64_t> counts() const;  // 1 to 8 whole numbers, at least 1

  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  const nlohmann::json* value_;
  std::string file_, place_;
};

// Of a metadata file; the bare words NaN, Infinity and -Infinity become texts. Keys that stand twice are
// added to `warnings`. Throws base::Error{input} with the byte where the text is no JSON object.
nlohmann::json parseJson(const std::string& text, const std::string& file,
                         std::vector<std::string>* warnings = nullptr);

}  // namespace isolux::volume
