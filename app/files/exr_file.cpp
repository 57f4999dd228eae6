#include "app/files/exr_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

#include <sys/types.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <tbb/global_control.h>

#include "app/files/files.h"
#include "base/error.h"

namespace isolux::app {

namespace {

// As many threads as the program may use; a few are enough for the compression. Where the system has none to
// give, the calling thread does the work.
int compressionThreads() {
  constexpr std::size_t most = 8;
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int wanted = allowed > 1 ? static_cast<int>(std::min(allowed, most)) : 0;
  try {
    if (Imf::globalThreadCount() != wanted) Imf::setGlobalThreadCount(wanted);
    return wanted;
  } catch (const std::exception&) {
    return 0;
  }
}

// OpenEXR's own stream loses what fails when the last buffer is written; this one keeps count of errors.
class CheckedStream final : public Imf::OStream {
 public:
  explicit CheckedStream(const std::filesystem::path& path)
      : OStream(path.c_str()), stream_(std::fopen(path.c_str(), "wb")) {
    if (!stream_) throwSystemReason();
  }
  ~CheckedStream() override {
    if (stream_) std::fclose(stream_);
  }
  CheckedStream(const CheckedStream&) = delete;
  CheckedStream& operator=(const CheckedStream&) = delete;

  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (std::fwrite(bytes, 1, size, stream_) != size) throwSystemReason();
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(::ftello(stream_)); }
  void seekp(std::uint64_t position) override {
    if (::fseeko(stream_, static_cast<::off_t>(position), SEEK_SET) != 0) throwSystemReason();
  }
  // To be called when the picture is written: an error of any write so far is thrown here at the latest.
  void close() {
    const bool failed = std::ferror(stream_) != 0;
    std::FILE* const stream = std::exchange(stream_, nullptr);
    if (std::fclose(stream) != 0 || failed) throwSystemReason();
  }

 private:
  [[noreturn]] static void throwSystemReason() {
    throw std::runtime_error(errno != 0 ? std::strerror(errno) : "input/output error");
  }

  std::FILE* stream_;
};

Imf::FrameBuffer frameBufferOf(glm::ivec2 size, const std::vector<ExrChannel>& channels) {
  Imf::FrameBuffer buffer;
  for (const ExrChannel& channel : channels) {
    // OpenEXR takes the same frame buffer for reading and writing; here it only reads.
    char* const first = const_cast<char*>(reinterpret_cast<const char*>(channel.first));
    const std::size_t pixelBytes = channel.stride * sizeof(float);
    buffer.insert(channel.name,
                  Imf::Slice(Imf::FLOAT, first, pixelBytes, pixelBytes * static_cast<std::size_t>(size.x)));
  }
  return buffer;
}

}  // namespace

void writeExrFile(glm::ivec2 size, const std::vector<ExrChannel>& channels,
                  const std::vector<std::pair<std::string, std::string>>& attributes,
                  const std::filesystem::path& file) {
  PendingFile pending(file);
  try {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrChannel& channel : channels)
      header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));
    CheckedStream stream(pending.path());
    {
      Imf::OutputFile output(stream, header, compressionThreads());
      output.setFrameBuffer(frameBufferOf(size, channels));
      output.writePixels(size.y);
    }  // which writes the table of lines
    stream.close();
  } catch (const std::exception& error) {
    base::throwInput(file.string(), "", std::string("cannot be written: ") + error.what());
  }
  pending.commit();
}

}  // namespace isolux::app
