// How soon long work ends once it is asked to stop, and what work costs.
#pragma once

#include <functional>

#include "base/progress.h"

namespace isolux::test {

// Runs `work` until it is stopped, at moments spread over the time that it takes undisturbed, and expects
// that half of the stops are heeded within 100 ms. The median of several moments: a machine that is busy with
// other things makes single ones late. Work that ends before its stop counts as heeding it.
void expectStopsSoon(const std::function<void(base::Progress&)>& work, int moments = 9);

// Time of all processors that this process spends in `work`.
double processorSeconds(const std::function<void()>& work);

}  // namespace isolux::test
