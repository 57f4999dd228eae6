#include "readers/hdf5/recording_driver.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isolux::readers {

namespace {

constexpr haddr_t kLargestAddress = (haddr_t{1} << 62) - 1;

// The library sees the first member.
struct ReadOnlyFile {
  H5FD_t shared{};
  int descriptor = -1;
  haddr_t allocated = 0, size = 0;
  dev_t device = 0;
  ino_t inode = 0;
};

ReadOnlyFile* fileOf(H5FD_t* file) {
  return reinterpret_cast<ReadOnlyFile*>(file);
}
const ReadOnlyFile* fileOf(const H5FD_t* file) {
  return reinterpret_cast<const ReadOnlyFile*>(file);
}

H5FD_t* openFile(const char* name, unsigned flags, hid_t, haddr_t) {
  if ((flags & (H5F_ACC_RDWR | H5F_ACC_TRUNC | H5F_ACC_CREAT)) != 0) return nullptr;
  const int descriptor = ::open(name, O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0) return nullptr;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return nullptr;
  }
  auto* const file = new ReadOnlyFile;
  file->descriptor = descriptor;
  file->size = static_cast<haddr_t>(status.st_size);
  file->device = status.st_dev;
  file->inode = status.st_ino;
  return &file->shared;
}

herr_t closeFile(H5FD_t* file) {
  ::close(fileOf(file)->descriptor);
  delete fileOf(file);
  return 0;
}

int compareFiles(const H5FD_t* a, const H5FD_t* b) {
  const ReadOnlyFile &one = *fileOf(a), &other = *fileOf(b);
  if (one.device != other.device) return one.device < other.device ? -1 : 1;
  return one.inode == other.inode ? 0 : one.inode < other.inode ? -1 : 1;
}

herr_t queryFeatures(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr) *flags = 0;
  return 0;
}

haddr_t allocatedEnd(const H5FD_t* file, H5FD_mem_t) {
  return fileOf(file)->allocated;
}
herr_t setAllocatedEnd(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  fileOf(file)->allocated = address;
  return 0;
}
haddr_t fileEnd(const H5FD_t* file, H5FD_mem_t) {
  return fileOf(file)->size;
}

herr_t readBytes(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t address, size_t size, void* out) {
  RecordedRead& record = recordedRead();
  if (record.recording && type == H5FD_MEM_DRAW) {
    record.happened = true;
    record.address = address;
    record.size = size;
    return 0;
  }
  auto* to = static_cast<char*>(out);
  while (size > 0) {
    const ssize_t got = ::pread(fileOf(file)->descriptor, to, size, static_cast<off_t>(address));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return -1;
    to += got;
    address += static_cast<haddr_t>(got);
    size -= static_cast<size_t>(got);
  }
  return 0;
}

herr_t refuseWrite(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, size_t, const void*) {
  return -1;
}

H5FD_class_t driverClass() {
  H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION  // HDF5 1.10 (Debian 12) has none
  driver.version = H5FD_CLASS_VERSION;
#endif
  driver.name = "isolux";
  driver.maxaddr = kLargestAddress;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.open = openFile;
  driver.close = closeFile;
  driver.cmp = compareFiles;
  driver.query = queryFeatures;
  driver.get_eoa = allocatedEnd;
  driver.set_eoa = setAllocatedEnd;
  driver.get_eof = fileEnd;
  driver.read = readBytes;
  driver.write = refuseWrite;
  const H5FD_mem_t single[] = H5FD_FLMAP_SINGLE;
  for (int i = 0; i < H5FD_MEM_NTYPES; ++i) driver.fl_map[i] = single[i];
  return driver;
}

}  // namespace

RecordedRead& recordedRead() {
  static RecordedRead record;
  return record;
}

hid_t recordingDriver() {
  static const H5FD_class_t driver = driverClass();
  static const hid_t id = ::H5FDregister(&driver);
  return id;
}

}  // namespace isolux::readers
