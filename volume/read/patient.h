// Who a volume is of, as far as its file says.
#pragma once

#include <string>

namespace isolux::volume {

// As DICOM writes them: "Family^Given", any text, YYYYMMDD; empty where the file does not say.
struct Patient {
  std::string name, id, birthDate;
  bool known() const { return !name.empty() || !id.empty() || !birthDate.empty(); }
  bool operator==(const Patient&) const = default;
};

}  // namespace isolux::volume
