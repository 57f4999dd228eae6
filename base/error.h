// Defines the exception type for errors of the user, of an input file or of the host.
//
// An Error becomes one line on stderr, "isolux: FILE: PLACE: REASON", and the exit code of its kind
// (docs/reference/outputs.md). Internal errors are asserts, not Errors. Exceptions never cross threads: a job
// catches the Error and stores it as a value, and the job's owner reads it.
#pragma once

#include <stdexcept>
#include <string>

namespace isolux::base {

// Error kinds; the values are the documented exit codes of the program.
enum class ErrorKind : int {
  usage = 2,         // the command line or a setting is wrong
  input = 3,         // the input is unreadable or rejected
  graphics = 4,      // no usable graphics context
  memory = 5,        // out of memory or over the memory budget
  interrupted = 130  // stopped by the user
};

class Error : public std::runtime_error {
 public:
  // `file` may be empty (a setting, the host). `place` is the position in it ("line 3", "DimSize", "byte
  // 352") and may be empty. `reason` is a sentence fragment without a full stop.
  Error(ErrorKind kind, std::string file, std::string place, std::string reason);

  ErrorKind kind() const { return kind_; }
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }
  const std::string& reason() const { return reason_; }

 private:
  ErrorKind kind_;
  std::string file_, place_, reason_;
};

// Throw an Error of one of the two most frequent kinds.
[[noreturn]] void throwInput(const std::string& file, const std::string& place, const std::string& reason);
[[noreturn]] void throwUsage(const std::string& file, const std::string& place, const std::string& reason);

}  // namespace isolux::base
