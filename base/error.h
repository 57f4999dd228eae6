// The one exception type for what a user, a file or a machine got wrong.
//
// An Error becomes one line on stderr, "isolux: FILE: PLACE: REASON", and the exit code of its kind
// (docs/reference/outputs.md). Internal errors are asserts, not Errors. Exceptions never cross threads: a
// job catches, keeps the Error as a value, and its owner reads it.
#pragma once

#include <stdexcept>
#include <string>

namespace isolux::base {

// The values are the documented exit codes of the program.
enum class ErrorKind : int {
  usage = 2,         // the command line or a setting is wrong
  input = 3,         // the input is unreadable or refused
  graphics = 4,      // no usable graphics context
  memory = 5,        // out of memory or over a budget
  interrupted = 130  // stopped by the user
};

class Error : public std::runtime_error {
 public:
  // `file` may be empty (a setting, the machine); `place` names the spot in it ("line 3", "DimSize",
  // "byte 352") and may be empty; `reason` is a sentence fragment without a full stop.
  Error(ErrorKind kind, std::string file, std::string place, std::string reason);

  ErrorKind kind() const { return kind_; }
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }
  const std::string& reason() const { return reason_; }

 private:
  ErrorKind kind_;
  std::string file_, place_, reason_;
};

// Shorthand for the most frequent kind.
[[noreturn]] void throwInput(const std::string& file, const std::string& place, const std::string& reason);

}  // namespace isolux::base
