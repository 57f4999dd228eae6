// Makes a crash of the test program say where: also in the driver, and in threads of others.
#pragma once

namespace isolux::test {

// From now on the calls of a thread that crashes are printed to stderr, as files and addresses within them,
// before the process ends as it would have. Sanitizers print their own: then this does nothing.
void traceCrashes();

}  // namespace isolux::test
