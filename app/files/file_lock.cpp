#include "app/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace isolux::app {

FileLock tryLock(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return nullptr;
  FileLock lock(new int(descriptor), [](const int* held) {
    ::close(*held);
    delete held;
  });
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? lock : nullptr;
}

}  // namespace isolux::app
