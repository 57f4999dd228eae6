#include "volume/read/input/patient.h"

#include <map>
#include <mutex>

namespace isolux::volume {

namespace {

struct Patients {
  std::mutex mutex;
  std::map<std::weak_ptr<const Grid>, Patient, std::owner_less<>> known;
};

Patients& patients() {
  static Patients all;
  return all;
}

}  // namespace

void rememberPatient(const std::shared_ptr<const Grid>& grid, const Patient& patient) {
  Patients& all = patients();
  const std::lock_guard lock(all.mutex);
  std::erase_if(all.known, [&](const auto& one) { return one.first.expired() || one.first.lock() == grid; });
  if (grid && patient.known()) all.known.emplace(grid, patient);
}

Patient patientOf(const std::shared_ptr<const Grid>& grid) {
  Patients& all = patients();
  const std::lock_guard lock(all.mutex);
  const auto found = all.known.find(grid);
  return found == all.known.end() ? Patient() : found->second;
}

}  // namespace isolux::volume
