#include "render/gl/program_cache.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/destroy_in_background.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/pending_file.h"
#include "render/gl/gl.h"

namespace isolux::render {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMagic = "ISOLUX PROGRAM 1\n";
constexpr const char* kExtension = ".program";
constexpr std::uint64_t kMostFileBytes = std::uint64_t{16} << 20;
// A file that is used is marked as new, at most once a day.
constexpr std::chrono::hours kBetweenMarks{24};

struct Configured {
  std::mutex mutex;
  ProgramStore store;
};
Configured& configured() {
  static Configured one;
  return one;
}

std::uint64_t hashOf(std::string_view text) {
  return base::Hasher().addWords(text.data(), text.size());
}
// A second hash with another state, so that two texts that share both are not met.
std::uint64_t otherHashOf(std::string_view text) {
  base::Hasher hash;
  hash.add(text.size());
  for (const char one : text) hash.add(one);
  return hash;
}

template <class Value>
void put(std::string& out, const Value& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
// Reads from the front of `bytes`. Returns false if too few are left.
template <class Value>
bool get(std::string_view& bytes, Value& value) {
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return true;
}

// The file of a program: magic, length of the identity, identity, format, binary, hash of all before.
std::string fileText(const std::string& identity, GLenum format, const std::vector<char>& binary) {
  std::string text(kMagic);
  put(text, static_cast<std::uint64_t>(identity.size()));
  text += identity;
  put(text, format);
  text.append(binary.data(), binary.size());
  put(text, hashOf(text));
  return text;
}

std::optional<std::string> readFile(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return std::nullopt;
  const std::uintmax_t bytes = fs::file_size(file, failed);
  if (failed || bytes > kMostFileBytes) return std::nullopt;
  std::string text(static_cast<std::size_t>(bytes), '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(text.size()))) return std::nullopt;
  return text;
}

struct Binary {
  GLenum format = 0;
  std::string_view bytes;  // within the file's text
};

std::optional<Binary> binaryOf(std::string_view text, const std::string& identity) {
  std::uint64_t sum = 0, length = 0;
  if (text.size() < sizeof sum) return std::nullopt;
  std::memcpy(&sum, text.data() + text.size() - sizeof sum, sizeof sum);
  text.remove_suffix(sizeof sum);
  if (hashOf(text) != sum || !text.starts_with(kMagic)) return std::nullopt;
  text.remove_prefix(kMagic.size());
  if (!get(text, length) || length != identity.size() || !text.starts_with(identity)) return std::nullopt;
  text.remove_prefix(identity.size());
  Binary binary;
  if (!get(text, binary.format) || text.empty()) return std::nullopt;
  binary.bytes = text;
  return binary;
}

bool takesFormat(const Gl& gl, GLenum format) {
  std::vector<GLint> formats(static_cast<std::size_t>(std::max(gl.programFormats, 0)));
  if (!formats.empty()) gl.GetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
  return std::find(formats.begin(), formats.end(), static_cast<GLint>(format)) != formats.end();
}

// Silences the driver about binaries that it does not take: that is no error of the picture.
class Silence {
 public:
  explicit Silence(const Gl& gl) : gl_(gl) { gl_.Disable(GL_DEBUG_OUTPUT); }
  ~Silence() {
    constexpr int most = 16;
    for (int i = 0; i < most && gl_.GetError() != GL_NO_ERROR; ++i) continue;
    gl_.Enable(GL_DEBUG_OUTPUT);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  const Gl& gl_;
};

struct StoredFile {
  fs::path path;
  std::uint64_t bytes = 0;
  fs::file_time_type time;
};

std::vector<StoredFile> filesOf(const fs::path& folder) {
  std::vector<StoredFile> files;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    std::error_code gone;  // another process may remove it now
    StoredFile file{at->path(), at->file_size(gone), at->last_write_time(gone)};
    if (!gone && file.path.extension() == kExtension) files.push_back(std::move(file));
  }
  return files;
}

// Removes the files that were not used for longest, down to three quarters of the limit.
void prune(const fs::path& folder, std::uint64_t mostBytes) {
  std::vector<StoredFile> files = filesOf(folder);
  std::uint64_t sum = 0;
  for (const StoredFile& file : files) sum += file.bytes;
  if (sum <= mostBytes) return;
  std::sort(files.begin(), files.end(),
            [](const StoredFile& a, const StoredFile& b) { return a.time < b.time; });
  std::error_code ignored;
  for (const StoredFile& file : files) {
    if (sum <= mostBytes / 4 * 3) return;
    fs::remove(file.path, ignored);
    sum -= file.bytes;
  }
}

// Files that wait to be written, by one thread at a time.
struct Writer {
  struct Job {
    fs::path file;
    std::string text;
    std::uint64_t mostBytes;
  };
  std::mutex mutex;
  std::vector<Job> jobs;
  bool running = false;

  void add(Job job) {
    {
      const std::lock_guard lock(mutex);
      jobs.push_back(std::move(job));
      if (std::exchange(running, true)) return;
    }
    base::runInBackground([this] { run(); });
  }

 private:
  void run() {
    for (;;) {
      std::vector<Job> now;
      {
        const std::lock_guard lock(mutex);
        if (jobs.empty()) {
          running = false;
          return;
        }
        now.swap(jobs);
      }
      for (const Job& job : now) write(job);
      prune(now.back().file.parent_path(), now.back().mostBytes);
    }
  }
  static void write(const Job& job) noexcept {
    try {
      std::error_code ignored;
      fs::create_directories(job.file.parent_path(), ignored);
      base::OutputFile out(job.file);
      out.write(job.text);
      out.commit();
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): the next start compiles it again
    }
  }
};
// Never destroyed: the thread may outlive the program's statics.
Writer& writer() {
  static auto* const one = new Writer;
  return *one;
}

}  // namespace

void setProgramStore(ProgramStore store) {
  const std::lock_guard lock(configured().mutex);
  configured().store = std::move(store);
}

ProgramStore programStore() {
  const std::lock_guard lock(configured().mutex);
  return configured().store;
}

StoredPrograms storedPrograms(const fs::path& folder) {
  StoredPrograms stored;
  for (const StoredFile& file : filesOf(folder)) {
    ++stored.count;
    stored.bytes += file.bytes;
  }
  return stored;
}

ProgramCache::ProgramCache(const Gl& gl, ProgramStore store)
    : store_(std::move(store)),
      driver_(gl.string(GL_VENDOR) + '\n' + gl.string(GL_RENDERER) + '\n' + gl.string(GL_VERSION) + '\n') {
  if (gl.programFormats < 1 || (gl.software && !store_.software)) store_.folder.clear();
}

std::string ProgramCache::identityOf(std::string_view vertex, std::string_view fragment) const {
  std::string identity = driver_ + store_.version + '\n';
  for (const std::string_view text : {vertex, fragment})
    identity += std::to_string(text.size()) + ' ' + std::to_string(hashOf(text)) + ' ' +
                std::to_string(otherHashOf(text)) + '\n';
  return identity;
}

fs::path ProgramCache::fileOf(const std::string& identity) const {
  return store_.folder / (std::to_string(hashOf(identity)) + kExtension);
}

bool ProgramCache::load(const Gl& gl, GLuint program, std::string_view vertex, std::string_view fragment) {
  if (store_.folder.empty()) return false;
  const std::string identity = identityOf(vertex, fragment);
  const fs::path file = fileOf(identity);
  const std::optional<std::string> text = readFile(file);
  if (!text) return false;
  const std::optional<Binary> binary = binaryOf(*text, identity);
  if (!binary || !takesFormat(gl, binary->format)) return false;
  GLint linked = 0;
  {
    const Silence silence(gl);
    gl.ProgramBinary(program, binary->format, binary->bytes.data(),
                     static_cast<GLsizei>(binary->bytes.size()));
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  }
  if (!linked) return false;
  ++counts_.cached;
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now();
  if (now - fs::last_write_time(file, ignored) > kBetweenMarks) fs::last_write_time(file, now, ignored);
  return true;
}

void ProgramCache::beforeLink(const Gl& gl, GLuint program) const {
  if (!store_.folder.empty()) gl.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
}

void ProgramCache::store(const Gl& gl, GLuint program, std::string_view vertex, std::string_view fragment) {
  ++counts_.compiled;
  if (store_.folder.empty()) return;
  GLint bytes = 0;
  gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &bytes);
  if (bytes <= 0 || static_cast<std::uint64_t>(bytes) > kMostFileBytes / 2) return;
  std::vector<char> binary(static_cast<std::size_t>(bytes));
  GLenum format = 0;
  GLsizei length = 0;
  {
    const Silence silence(gl);
    gl.GetProgramBinary(program, bytes, &length, &format, binary.data());
  }
  if (length <= 0 || length > bytes) return;
  binary.resize(static_cast<std::size_t>(length));
  const std::string identity = identityOf(vertex, fragment);
  writer().add({fileOf(identity), fileText(identity, format, binary), store_.mostBytes});
}

}  // namespace isolux::render
