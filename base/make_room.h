// A cache lets go of what it keeps before what it makes is refused memory.
#pragma once

#include "base/error.h"

namespace isolux::base {

// Returns make(). Where that throws Error{memory}, calls forget(), which drops something kept and returns
// whether there was anything, and tries again; throws the error where nothing is kept.
template <class Make, class Forget>
auto madeWithRoom(const Make& make, const Forget& forget) {
  for (;;) try {
      return make();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::memory || !forget()) throw;
    }
}

}  // namespace isolux::base
