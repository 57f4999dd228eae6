#include "readers/hdf5/hdf5_handles.h"

namespace isolux::readers {

namespace {

// The innermost comes first when walking upwards.
herr_t noteComplaint(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

}  // namespace

Hdf5Handle::~Hdf5Handle() {
  if (id_ >= 0) ::H5Idec_ref(id_);
}

std::string hdf5Complaint() {
  std::string text;
  ::H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, noteComplaint, &text);
  return text.empty() ? "the HDF5 library does not say why" : text;
}

void silenceHdf5() {
  ::H5open();
  ::H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  ::H5PLset_loading_state(0);
}

}  // namespace isolux::readers
