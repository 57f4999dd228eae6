// Values of DICOM elements: what is missing, too short or not finite is none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkDICOMValue;

namespace isolux::readers {

// Trimmed, UTF-8; several values are joined by "\".
std::string textIn(const vtkDICOMValue& value);

// The first `count` values, or an empty list.
std::vector<double> numbersIn(const vtkDICOMValue& value, std::size_t count);

std::optional<double> numberIn(const vtkDICOMValue& value);

}  // namespace isolux::readers
