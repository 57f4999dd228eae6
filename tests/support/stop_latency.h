// What work goes on with once it is asked to stop, and what work costs. Both in time of the processors, which
// other programs do not get longer by having turns of their own.
#pragma once

#include <functional>

#include "base/progress.h"

namespace isolux::test {

// Runs `work` until it is stopped, at moments spread over what it costs undisturbed, and expects that half of
// the stops leave most of the rest undone: at most a quarter of the whole is spent after the stop in the
// median, where work that never looks spends half. Of work that is short, what all cores can do in 10 ms,
// several times what is spent. Work that ends before its stop counts as stopped. How long that took by the
// clock is printed.
void expectStopsSoon(const std::function<void(base::Progress&)>& work, int moments = 9);

// Time of all processors that this process spends in `work`.
double processorSeconds(const std::function<void()>& work);

}  // namespace isolux::test
