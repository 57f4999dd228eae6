// A test that waits for ever, as in a dialog that nobody answers, ends the program instead of holding it up.
#pragma once

namespace isolux::test {

// From now on each test may take three minutes of wall time; one that takes longer is named on stderr, and
// the program is aborted there, so that a debugger or core file shows what it waited for. Call once.
void boundEachTest();

// Three minutes from now for the running test: for one that is as long as its user wants, at each step.
void restartTimeBound();

}  // namespace isolux::test
