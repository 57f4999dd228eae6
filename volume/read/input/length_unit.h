// Units of length by the names that files give them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::volume {

// mm in a unit of length ("micrometer", "um", "microns", "\u00b5m"); nothing for one that is not known.
std::optional<double> millimetresIn(std::string_view unit);

// The same; 1 for a unit that is not known, with a warning that casts doubt on lengths (length_doubt.h),
// given once. `statement` names the field; empty: it is the file's one unit, which may be missing.
double millimetresOr1(std::string_view unit, std::string_view statement, std::vector<std::string>& warnings);

}  // namespace isolux::volume
