// The texts that the window shows and that stand in no source of ui/: those of lists of the layers below, and
// of sentences that are put together from them. lupdate does not see them; isolux_texts tells it of them.
#pragma once

#include <set>
#include <string>
#include <utility>

namespace isolux::test {

// Context and English text of each, as ui/language looks them up. Call it without translations installed.
// Throws std::runtime_error when the sources of the repository are not there, where names of stages are
// looked for.
std::set<std::pair<std::string, std::string>> listedTexts();

}  // namespace isolux::test
