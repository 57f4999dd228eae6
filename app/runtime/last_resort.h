// How the program ends when an exception has nobody left to catch it: memory or threads refused where
// libraries do not expect it, before main() or on their threads. One line and a documented exit code, no
// abort.
#pragma once

namespace isolux::app {

// Takes std::terminate's place in this process. Where the address space has a limit (ulimit -v), malloc keeps
// to one arena besides: each thread's own would take 64 MiB of it. To be called before threads exist; from
// any moment after the program is loaded, static initialisation included.
void installLastResort() noexcept;

}  // namespace isolux::app
