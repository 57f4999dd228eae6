#include "readers/dicom/elements.h"

#include <cmath>

#include <vtkDICOMValue.h>

#include "volume/read/input/text.h"

namespace isolux::readers {

std::string textIn(const vtkDICOMValue& value) {
  return value.IsValid() ? std::string(volume::trimmed(value.AsUTF8String())) : std::string();
}

std::vector<double> numbersIn(const vtkDICOMValue& value, std::size_t count) {
  std::vector<double> numbers;
  if (!value.IsValid() || value.GetNumberOfValues() < count) return numbers;
  for (std::size_t i = 0; i < count; ++i) {
    numbers.push_back(value.GetDouble(i));
    if (!std::isfinite(numbers.back())) return {};
  }
  return numbers;
}

std::optional<double> numberIn(const vtkDICOMValue& value) {
  const std::vector<double> numbers = numbersIn(value, 1);
  return numbers.empty() ? std::nullopt : std::optional(numbers[0]);
}

}  // namespace isolux::readers
