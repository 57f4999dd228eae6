// Retries an allocation after evicting cache entries.
#pragma once

#include "base/error.h"

namespace isolux::base {

// Returns make(). If that throws Error{memory}, calls forget() and tries again. forget() evicts one entry and
// returns whether there was one. Throws the error if nothing is left to evict.
template <class Make, class Forget>
auto madeWithRoom(const Make& make, const Forget& forget) {
  for (;;) try {
      return make();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::memory || !forget()) throw;
    }
}

}  // namespace isolux::base
