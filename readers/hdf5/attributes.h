// Attributes and small datasets of HDF5 objects as numbers and texts. What is of another kind counts as
// absent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <hdf5.h>

#include "volume/read/chunks/cf_attributes.h"

namespace isolux::readers {

// Those with at most 1024 numbers, and single texts.
volume::Attributes attributesOf(hid_t object);

std::vector<double> numbersOfAttribute(hid_t object, const char* name);
// Of fixed or variable length; a list of single letters is one text to attributesOf(), as Imaris writes it.
std::vector<std::string> textsOfAttribute(hid_t object, const char* name);

// All numbers of the dataset at `path`; none where there is no such dataset, or more of them than `most`.
std::vector<double> numbersOfDataset(hid_t location, const std::string& path, std::uint64_t most);

}  // namespace isolux::readers
