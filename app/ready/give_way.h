// For threads whose work nobody waits for.
#pragma once

namespace isolux::app {

// From now on the calling thread gets a tenth of a processor that somebody else wants, as threads that
// compute light.
void giveWay();

}  // namespace isolux::app
