#include "base/pending_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "base/supervision.h"

namespace isolux::base {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestNamePart = 200;  // of the 255 bytes that file systems allow
constexpr std::chrono::milliseconds kLongestWaitOnTheWayOut{20};
// Whoever looks whether a lock is abandoned holds it for a moment, too.
constexpr int kMostTriesToLock = 20;
constexpr std::chrono::milliseconds kBetweenTriesToLock{5};

struct Pending {
  std::timed_mutex mutex;
  std::vector<fs::path> paths;     // of files that are not committed, and of locks
  std::set<fs::path> tidyFolders;  // that were looked through for files of dead processes
};

// Never destroyed: an interrupt may come while the program's statics go away.
Pending& pending() {
  static Pending* const list = new Pending;
  return *list;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// ".NAME.PID-N.part", as PendingFile makes them.
bool isPartName(const std::string& name) {
  constexpr std::string_view ending = ".part";
  if (!name.starts_with('.') || !name.ends_with(ending)) return false;
  const std::string stem = name.substr(0, name.size() - ending.size());
  const std::size_t dot = stem.rfind('.'), dash = stem.rfind('-');
  const auto digits = [&](std::size_t from, std::size_t to) {
    return from < to && std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(from),
                                    stem.begin() + static_cast<std::ptrdiff_t>(to),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
  };
  return dot != 0 && dot != std::string::npos && dash != std::string::npos && dash > dot &&
         digits(dot + 1, dash) && digits(dash + 1, stem.size());
}

// Removes `part` if its writer is gone. Where the file system knows no locks nothing is removed.
void removeAbandoned(const fs::path& part) {
  const int file = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && ::flock(file, LOCK_EX | LOCK_NB) == 0)
    ::unlink(part.c_str());
  ::close(file);
}

void removeAbandonedIn(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (isPartName(entry->path().filename().string())) removeAbandoned(entry->path());
}

constexpr const char* kDescriptors = "/proc/self/fd";

// Of a path "/proc/self/fd/N", by any name of that folder: N; else -1.
int descriptorOf(const fs::path& file) {
  std::error_code error;
  if (!fs::equivalent(folderOf(file), kDescriptors, error)) return -1;
  int number = -1;
  const std::string name = file.filename().string();
  const auto [rest, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
  return failure == std::errc{} && rest == name.data() + name.size() ? number : -1;
}

// What is written into where it stands, not replaced: a descriptor of this process, a pipe, a device.
bool isStream(const fs::path& written) {
  std::error_code ignored;
  const fs::file_type type = fs::status(written, ignored).type();
  return descriptorOf(written) >= 0 || type == fs::file_type::fifo || type == fs::file_type::character;
}

// Another descriptor of the same open file, where it stands. Throws Error{input}.
int openStream(const fs::path& target, const fs::path& written) {
  const int number = descriptorOf(written);
  errno = 0;
  const int stream = number >= 0 ? ::fcntl(number, F_DUPFD_CLOEXEC, 0)
                                 : ::open(written.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (stream < 0) throwCannotWrite(target, errno);
  return stream;
}

struct OpenFile {
  explicit OpenFile(int opened) : number(opened) {}
  ~OpenFile() { ::close(number); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number;
};

void copyInto(int stream, int part, const fs::path& target) {
  std::array<char, 1 << 16> buffer{};
  for (ssize_t read = 0; (read = ::read(part, buffer.data(), buffer.size())) != 0;) {
    if (read < 0) throwCannotWrite(target, errno);
    for (ssize_t done = 0; done < read;) {
      const ssize_t wrote = ::write(stream, buffer.data() + done, static_cast<std::size_t>(read - done));
      if (wrote < 0 && errno != EINTR) throwCannotWrite(target, errno);
      if (wrote > 0) done += wrote;
    }
  }
}

fs::path temporaryFolder(const fs::path& target) {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) throwCannotWrite(target, error.value());
  return folder;
}

void checkStream(const fs::path& target, const fs::path& written) {
  const int number = descriptorOf(written);
  errno = 0;
  const int flags = number < 0 ? O_WRONLY : ::fcntl(number, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) throwCannotWrite(target, flags < 0 ? errno : EBADF);
}

void checkTarget(const fs::path& target, const fs::path& written) {
  std::error_code ignored;
  if (fs::is_symlink(written, ignored))  // after forty of them
    throwInput(target.string(), "", "is a symbolic link that leads nowhere");
  const fs::file_status status = fs::status(written, ignored);
  if (fs::is_directory(status)) throwInput(target.string(), "", "is a folder, not a file to write");
  if (written.filename().empty()) throwInput(target.string(), "", "is not the name of a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throwInput(target.string(), "", "is not a regular file");
  constexpr fs::perms writable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (fs::exists(status) &&
      ((status.permissions() & writable) == fs::perms::none || ::access(written.c_str(), W_OK) != 0))
    throwInput(target.string(), "", "is read-only and is not replaced");
  if (!fs::is_directory(folderOf(written), ignored))
    throwInput(target.string(), "", "cannot be written: its folder does not exist");
}

}  // namespace

void throwCannotWrite(const fs::path& target, int errorNumber) {
  throwInput(target.string(), "",
             "cannot be written: " +
                 (errorNumber != 0 ? std::generic_category().message(errorNumber) : "input/output error"));
}

fs::path writtenPath(const fs::path& file) {
  constexpr int mostLinks = 40;  // as the kernel has it
  fs::path path = file;
  std::error_code error;
  for (int i = 0; i < mostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    if (descriptorOf(path) >= 0) break;  // the file behind it is not replaced
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

PendingFile::PendingFile(fs::path target)
    : target_(std::move(target)), written_(writtenPath(target_)), isStream_(isStream(written_)) {
  if (isStream_)
    checkStream(target_, written_);
  else
    checkTarget(target_, written_);
  const fs::path folder = isStream_ ? temporaryFolder(target_) : folderOf(written_);
  {
    std::error_code ignored;
    const std::lock_guard lock(pending().mutex);
    if (pending().tidyFolders.insert(fs::absolute(folder, ignored)).second) removeAbandonedIn(folder);
  }
  errno = 0;
  while (!make(folder)) {
    if (errno != EEXIST && errno != EWOULDBLOCK) throwCannotWrite(target_, errno);
  }
}

// False with errno: this name is taken, or another process took the file for an abandoned one.
bool PendingFile::make(const fs::path& folder) {
  static std::atomic<unsigned> count{0};
  const std::string name = written_.filename().string().substr(0, kLongestNamePart);
  const fs::path part =
      folder / ("." + name + "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".part");
  const std::lock_guard guard(pending().mutex);
  announcePending(part);
  const int file = ::open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    const int error = errno;
    withdrawPending(part);
    errno = error;
    return false;
  }
  const bool locked =
      ::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;  // no locks here: so be it
  struct stat status {};
  if (!locked || ::fstat(file, &status) != 0 || status.st_nlink == 0) {
    ::close(file);
    withdrawPending(part);
    errno = EWOULDBLOCK;
    return false;
  }
  lock_ = file;
  path_ = part;
  pending().paths.push_back(path_);
  return true;
}

PendingFile::~PendingFile() {
  {
    const std::lock_guard lock(pending().mutex);
    if (!committed_) {
      std::erase(pending().paths, path_);
      ::unlink(path_.c_str());
      withdrawPending(path_);
    }
  }
  ::close(lock_);
}

void PendingFile::takeRights() const {
  struct stat old {
  }, own{};
  if (::stat(written_.c_str(), &old) != 0) return;
  const bool sameOwner =
      ::stat(path_.c_str(), &own) == 0 && own.st_uid == old.st_uid && own.st_gid == old.st_gid;
  if (!sameOwner && ::chown(path_.c_str(), old.st_uid, old.st_gid) != 0)
    errno = 0;  // only root may give files away
  if (::chmod(path_.c_str(), old.st_mode & 0777) != 0) throwCannotWrite(target_, errno);
}

void PendingFile::sync() {
  if (synced_) return;
  // Opened anew: a writer may have replaced the file instead of writing into it.
  const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throwCannotWrite(target_, errno);
  const bool done = ::fsync(file) == 0 || errno == EINVAL || errno == EROFS;  // not every file system can
  const int error = errno;
  ::close(file);
  if (!done) throwCannotWrite(target_, error);
  if (!isStream_) takeRights();
  synced_ = true;
}

// Behind what was printed before.
void PendingFile::writeIntoStream() const {
  std::fflush(stdout);
  const int part = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (part < 0) throwCannotWrite(target_, errno);
  const OpenFile source(part), stream(openStream(target_, written_));
  copyInto(stream.number, source.number, target_);
}

void PendingFile::commit() {
  sync();
  if (isStream_) return writeIntoStream();  // the destructor removes the part
  {
    const std::lock_guard lock(pending().mutex);
    if (std::rename(path_.c_str(), written_.c_str()) != 0) throwCannotWrite(target_, errno);
    std::erase(pending().paths, path_);
    withdrawPending(path_);
    committed_ = true;
  }
  const int folder = ::open(folderOf(written_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // the file stands; only its name may be lost in a power cut
  ::fsync(folder);
  ::close(folder);
}

OutputLock::OutputLock(const fs::path& target) {
  const fs::path written = writtenPath(target);
  if (isStream(written)) return;
  // The end of a long name: parts of one bake differ there.
  const std::string name = written.filename().string();
  const std::string end = name.substr(name.size() - std::min(name.size(), kLongestNamePart));
  path_ = folderOf(written) / ("." + end + ".0-0.part");
  for (int tries = 0; !tryLock(); ++tries) {
    if (tries == kMostTriesToLock)
      throwInput(target.string(), "",
                 "another isolux is at work on this file; wait until it ends, or choose another name");
    std::this_thread::sleep_for(kBetweenTriesToLock);
  }
}

// False: another one holds it, or has just removed its file.
bool OutputLock::tryLock() {
  const std::lock_guard guard(pending().mutex);
  int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file < 0) file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);  // another user's
  if (file < 0) return true;  // who writes there will say why that is not possible
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    const bool held = errno == EWOULDBLOCK || errno == EINTR;
    if (!held) ::unlink(path_.c_str());  // no locks here: so be it
    ::close(file);
    return !held;
  }
  struct stat locked {
  }, named{};
  if (::fstat(file, &locked) != 0 || ::stat(path_.c_str(), &named) != 0 || locked.st_ino != named.st_ino ||
      locked.st_dev != named.st_dev) {
    ::close(file);
    return false;
  }
  lock_ = file;
  announcePending(path_);
  pending().paths.push_back(path_);
  return true;
}

OutputLock::OutputLock(OutputLock&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

OutputLock::~OutputLock() {
  if (lock_ < 0) return;
  {
    const std::lock_guard guard(pending().mutex);
    std::erase(pending().paths, path_);
    ::unlink(path_.c_str());
    withdrawPending(path_);
  }
  ::close(lock_);
}

void removePendingFiles() noexcept {
  // Not waiting for long: who holds the lock may be in a slow rename, and its file is then complete.
  const std::unique_lock lock(pending().mutex, kLongestWaitOnTheWayOut);
  if (lock.owns_lock())
    for (const fs::path& path : pending().paths) ::unlink(path.c_str());
}

OutputFile::OutputFile(fs::path target) : pending_(std::move(target)) {
  errno = 0;
  stream_ = std::fopen(pending_.path().c_str(), "wbe");
  if (!stream_) throwCannotWrite(pending_.target(), errno);
}

OutputFile::~OutputFile() {
  if (stream_) std::fclose(stream_);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  errno = 0;
  if (count > 0 && std::fwrite(bytes, 1, count, stream_) != count) throwCannotWrite(pending_.target(), errno);
}

std::uint64_t OutputFile::at() const {
  return static_cast<std::uint64_t>(ftello(stream_));
}

void OutputFile::go(std::uint64_t byte) {
  errno = 0;
  if (fseeko(stream_, static_cast<off_t>(byte), SEEK_SET) != 0) throwCannotWrite(pending_.target(), errno);
}

void OutputFile::finish() {
  if (!stream_) return;
  errno = 0;
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) throwCannotWrite(pending_.target(), errno);
  pending_.sync();
}

void OutputFile::commit() {
  finish();
  pending_.commit();
}

}  // namespace isolux::base
