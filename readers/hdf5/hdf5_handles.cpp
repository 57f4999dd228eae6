#include "readers/hdf5/hdf5_handles.h"

namespace isolux::readers {

namespace {

// The innermost comes first when walking upwards.
herr_t noteComplaint(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

std::string& lastTarget() {
  static std::string target;
  return target;
}

herr_t refuseExternal(const char*, const char*, const char* file, const char* object, unsigned*, hid_t,
                      void*) {
  lastTarget() = std::string(file) + ":" + object;
  return -1;
}

// The library would read other files by another driver, and whatever file a name leads to.
hid_t ownLinksOnly() {
  static const hid_t access = [] {
    const hid_t list = ::H5Pcreate(H5P_LINK_ACCESS);
    ::H5Pset_elink_cb(list, refuseExternal, nullptr);
    return list;
  }();
  return access;
}

}  // namespace

Hdf5Handle openedObject(hid_t location, const std::string& path) {
  lastTarget().clear();
  return Hdf5Handle(::H5Oopen(location, path.c_str(), ownLinksOnly()));
}

const std::string& externalTarget() {
  return lastTarget();
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
