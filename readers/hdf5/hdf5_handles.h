// Objects of the HDF5 library that close themselves, and its complaints as base::Error{input}.
#pragma once

#include <string>
#include <utility>

#include <hdf5.h>

namespace isolux::readers {

class Hdf5Handle {
 public:
  explicit Hdf5Handle(hid_t id = H5I_INVALID_HID) : id_(id) {}
  ~Hdf5Handle() {
    if (id_ >= 0) ::H5Idec_ref(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
};

// Opens an object by its path through hard and soft links of its own file; external links are not followed.
// H5Oopen() otherwise: not valid where there is none.
Hdf5Handle openedObject(hid_t location, const std::string& path);
// Where the external link leads that the last openedObject() met, "FILE:/path"; "" where it met none.
const std::string& externalTarget();

// What the library complained of last, in its words; no stack of it is printed after silenceHdf5().
std::string hdf5Complaint();
// No messages on stderr, no filters loaded from elsewhere.
void silenceHdf5();

}  // namespace isolux::readers
