// Who a volume is of, as far as its file says.
//
// Kept beside the volumes, by their grids, and no part of them: what copies, prints or stores a Volume names
// nobody unless it asks here. Any thread.
#pragma once

#include <memory>
#include <string>

namespace isolux::volume {

class Grid;

// As DICOM writes them: "Family^Given", any text, YYYYMMDD; empty where the file does not say.
struct Patient {
  std::string name, id, birthDate;
  bool known() const { return !name.empty() || !id.empty() || !birthDate.empty(); }
  bool operator==(const Patient&) const = default;
};

// For as long as the grid lives.
void rememberPatient(const std::shared_ptr<const Grid>& grid, const Patient& patient);
Patient patientOf(const std::shared_ptr<const Grid>& grid);  // nothing known: empty texts

}  // namespace isolux::volume
