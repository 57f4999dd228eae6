// What goes wrong on a thread in the background, as a value: no exception leaves the thread, ours or a
// library's.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"

namespace isolux::app {

// Calls work(), which does what `does` says ("draw a slice") with `file`; "": with none.
template <class Work>
std::optional<base::Error> caughtError(const std::string& file, const std::string& does, Work&& work) {
  try {
    std::forward<Work>(work)();
    return std::nullopt;
  } catch (const base::Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return base::Error(base::ErrorKind::memory, file, "", "not enough memory to " + does);
  } catch (const std::exception& error) {
    return base::Error(base::ErrorKind::input, file, "", "cannot " + does + ": " + error.what());
  } catch (...) {
    return base::Error(base::ErrorKind::input, file, "", "cannot " + does);
  }
}

}  // namespace isolux::app
