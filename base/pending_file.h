// Files that appear whole or not at all: written beside their name, on the disk, then renamed.
//
// Until commit() a file lives beside its target as ".NAME.PID-N.part", locked (flock) as long as its writer
// lives. A failure or an interrupt removes it and leaves the old file, or none; what a killed process left is
// removed by the next write to the same folder, which tells it by the lock that nobody holds any more.
//
// A symbolic link stays one: the file it leads to is replaced, also when that does not exist yet. Access
// rights (and the owner, where the system allows it) of a replaced file are kept; a file without any write
// permission is refused, also for root. A pipe, a device and a descriptor of this process (/dev/stdout,
// /dev/fd/N) are not replaced: the part lies in the folder for temporary files, and commit() writes it into
// them. commit() returns after the system has put file and name on the disk.
//
// A command that works for long takes an OutputLock first: ".NAME.0-0.part", locked in the same way, keeps
// others from the same work.
//
// Errors: base::Error{input} naming the target and the system's reason. Any thread may use files of its own.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace isolux::base {

// The file that writing to `file` would replace: symbolic links followed, the last one may lead nowhere;
// those that stand for descriptors of this process are not followed.
std::filesystem::path writtenPath(const std::filesystem::path& file);

// For writers that open files by name: the empty file stands at path() from the start.
class PendingFile {
 public:
  // Throws when the folder does not exist or cannot be written, or the target is something other than a
  // regular file that may be replaced, or a stream.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& path() const { return path_; }      // write here
  const std::filesystem::path& target() const { return target_; }  // the name it was asked for
  void sync();    // to the disk; commit() does it unless it was done
  void commit();  // the writer has closed the file

 private:
  bool make(const std::filesystem::path& folder);
  void takeRights() const;
  void writeIntoStream() const;

  std::filesystem::path target_, written_, path_;
  bool isStream_;
  int lock_ = -1;  // descriptor that holds the lock
  bool synced_ = false, committed_ = false;
};

// Keeps a second command from working for the same file, as long as it lives. Nothing is held of a stream,
// nor where the file system knows no locks.
class OutputLock {
 public:
  // Throws where another process, or another OutputLock of this one, works for the target.
  explicit OutputLock(const std::filesystem::path& target);
  ~OutputLock();
  OutputLock(OutputLock&& other) noexcept;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  bool tryLock();

  std::filesystem::path path_;
  int lock_ = -1;  // descriptor that holds the lock
};

// Removes every PendingFile that is not committed, and what locks others out: for the way out after an
// interrupt. The process must end at once, or their writers fail.
void removePendingFiles() noexcept;

// A PendingFile with a stream whose every failure is an Error: a full disk, a limit of size, at any byte.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return pending_.path(); }  // until commit()
  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  std::uint64_t at() const;     // bytes from the beginning
  void go(std::uint64_t byte);  // where the next write() goes
  void finish();                // all of it is on the disk, not yet under its name: commit() does both
  void commit();

 private:
  PendingFile pending_;
  std::FILE* stream_ = nullptr;
};

// "cannot be written: REASON" about `target`, with the reason of this errno.
[[noreturn]] void throwCannotWrite(const std::filesystem::path& target, int errorNumber);

}  // namespace isolux::base
