// Writes files atomically: under a temporary name, flushed to the disk, then renamed.
//
// Until commit(), a file is stored next to its target as ".NAME.PID-N.part" and locked (flock) while its
// writer lives. A failure or an interrupt removes it and leaves the old file, or none. The next write to the
// same folder removes the files that killed processes left, recognised by their free locks.
//
// A symbolic link stays: the file that it leads to is replaced or created. The new file gets the access
// rights of the replaced one, and its owner where the system allows it. A file without any write permission
// is rejected, also for root. commit() returns after the system has written file and name to the disk.
//
// A pipe, a device and a descriptor of this process (/dev/stdout, /dev/fd/N) are not replaced. The temporary
// file is then in the folder for temporary files, and commit() copies it into them.
//
// A long command first creates an OutputLock, ".NAME.0-0.part", locked in the same way. It keeps other
// commands from the same work.
//
// Throws base::Error{input} that names the target and the system's reason. Different threads may use
// different objects.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace isolux::base {

// Returns the file that writing to `file` would replace. Follows symbolic links, the last of which may lead
// to no file. Does not follow those that stand for descriptors of this process.
std::filesystem::path writtenPath(const std::filesystem::path& file);

// A temporary file for writers that open files by name: the empty file exists at path() from construction.
class PendingFile {
 public:
  // Throws if the folder does not exist or is not writable. Throws if the target is neither a replaceable
  // regular file nor a stream.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& path() const { return path_; }      // the file to write to
  const std::filesystem::path& target() const { return target_; }  // the name passed to the constructor
  void sync();    // flushes to the disk; commit() does so unless it was done
  void commit();  // requires that the writer has closed the file

 private:
  bool make(const std::filesystem::path& folder);
  void takeRights() const;
  void writeIntoStream() const;

  std::filesystem::path target_, written_, path_;
  bool isStream_;
  int lock_ = -1;  // descriptor that holds the lock
  bool synced_ = false, committed_ = false;
};

// Keeps a second command from working on the same file, for its lifetime. Locks nothing for a stream, nor
// where the file system supports no locks.
class OutputLock {
 public:
  // Throws if another process, or another OutputLock of this one, works on the target.
  explicit OutputLock(const std::filesystem::path& target);
  ~OutputLock();
  OutputLock(OutputLock&& other) noexcept;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  bool tryLock();

  std::filesystem::path path_;
  int lock_ = -1;  // descriptor that holds the lock
};

// Removes every uncommitted PendingFile and every OutputLock's file, for the exit after an interrupt. The
// process must end at once, or their writers fail.
void removePendingFiles() noexcept;

// A PendingFile with an output stream. Every failure throws an Error: a full disk, a file size limit, at any
// byte.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return pending_.path(); }  // valid until commit()
  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  std::uint64_t at() const;     // position, bytes from the beginning
  void go(std::uint64_t byte);  // sets the position of the next write()
  void finish();  // flushes all to the disk, not yet under the target's name; commit() does both
  void commit();

 private:
  PendingFile pending_;
  std::FILE* stream_ = nullptr;
};

// Throws "cannot be written: REASON" for `target`, with the text of `errorNumber` (errno).
[[noreturn]] void throwCannotWrite(const std::filesystem::path& target, int errorNumber);

}  // namespace isolux::base
