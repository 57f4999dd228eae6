// Runs the built isolux beside the window, as a shell would.
#pragma once

#include <filesystem>
#include <string>

namespace isolux::test {

// `arguments` as they are typed, in `folder`. The exit code; what it prints goes to the test's own output.
int runProgram(const std::string& arguments, const std::filesystem::path& folder);

}  // namespace isolux::test
