// Tries a property on random cases for a while, makes the first that fails as simple as it can, and prints it
// as a line for kept_cases.txt.
//
// ISOLUX_PROPERTY_SECONDS: for all properties together (25). ISOLUX_PROPERTY_SEED: which cases: a number (1),
// or `random`, which is printed.
#pragma once

#include <functional>
#include <string>

#include "tests/properties/property_case.h"

namespace isolux::test {

// What is wrong; empty where the property holds. Throwing is wrong, too.
using Property = std::function<std::string(const PropertyCase&)>;

// The simplest case near `failing` that fails, too: each step takes the first simpler one that does, until
// none does or `tries` are used up.
PropertyCase shrunk(const PropertyCase& failing, const Property& property, int tries);

// First the kept cases of this name, then random ones; at least three of them. share: of the seconds.
void expectHolds(const std::string& name, double share, const Property& property);

}  // namespace isolux::test
