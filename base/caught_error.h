// Converts exceptions on a background thread to values: no exception leaves the thread, whether from Isolux
// or a library.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"

namespace isolux::base {

// Calls work() and returns its error. `does` names the action ("draw a slice") and `file` the file, or "".
template <class Work>
std::optional<Error> caughtError(const std::string& file, const std::string& does, Work&& work) {
  try {
    std::forward<Work>(work)();
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorKind::memory, file, "", "not enough memory to " + does);
  } catch (const std::exception& error) {
    return Error(ErrorKind::input, file, "", "cannot " + does + ": " + error.what());
  } catch (...) {
    return Error(ErrorKind::input, file, "", "cannot " + does);
  }
}

}  // namespace isolux::base
