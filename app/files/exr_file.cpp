// The EXR files of image_io.h, by OpenEXR: float32, compressed without loss (zip).
#include <algorithm>
#include <cstdint>
#include <exception>
#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <tbb/global_control.h>

#include "app/files/image_io.h"
#include "app/version.h"
#include "base/error.h"
#include "base/pending_file.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// A channel of size.x * size.y values, row 0 at the top: every `stride`th from `first`.
struct ExrChannel {
  std::string name;
  const float* first;
  std::size_t stride;
};

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

// Writes into a file. OpenEXR loses what fails when it ends a picture; throwIfFailed() throws it.
class FileStream final : public Imf::OStream {
 public:
  explicit FileStream(base::OutputFile& file) : OStream(file.path().c_str()), file_(file) {}

  void write(const char bytes[], int count) override {
    keepFailure([&] { file_.write(bytes, static_cast<std::size_t>(count)); });
  }
  std::uint64_t tellp() override { return file_.at(); }
  void seekp(std::uint64_t position) override {  // which writes what is in the buffer
    keepFailure([&] { file_.go(position); });
  }

  void throwIfFailed() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Work>
  void keepFailure(const Work& work) {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }

  base::OutputFile& file_;
  std::exception_ptr failure_;
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

void writeChannels(glm::ivec2 size, const std::vector<ExrChannel>& channels, const fs::path& file,
                   const std::string& session) {
  base::OutputFile written(file);
  try {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrChannel& channel : channels)
      header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    for (const auto& [name, text] : pictureTexts(session)) header.insert(name, Imf::StringAttribute(text));
    FileStream stream(written);
    {
      Imf::OutputFile output(stream, header, compressionThreads());
      output.setFrameBuffer(frameBufferOf(size, channels));
      output.writePixels(size.y);
    }  // which writes the table of lines
    stream.throwIfFailed();
  } catch (const base::Error&) {
    throw;
  } catch (const std::exception& error) {
    base::throwInput(file.string(), "", std::string("cannot be written: ") + error.what());
  }
  written.commit();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> pictureTexts(const std::string& session) {
  std::vector<std::pair<std::string, std::string>> texts{{"Software", "isolux " + std::string(version())}};
  if (!session.empty()) texts.emplace_back(sessionKey, session);
  return texts;
}

void writeExr(const render::LinearImage* color, const std::vector<render::AovImage>& images,
              const fs::path& file, const std::string& session) {
  std::vector<ExrChannel> channels;
  if (color)
    for (std::size_t i = 0; i < (color->transparent ? 4 : 3); ++i)
      channels.push_back({std::string(1, "RGBA"[i]), color->rgba.data() + i, 4});
  if (!color && images.empty()) throw std::logic_error("writeExr: no channels");
  const glm::ivec2 size = color ? color->size : images.front().size;
  for (const render::AovImage& image : images) {
    if (image.size != size) throw std::logic_error("writeExr: sizes differ");
    const auto info = std::ranges::find(render::aovs(), image.aov, &render::AovInfo::aov);
    const auto count = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string suffix = info->channels.at(i);
      channels.push_back(
          {suffix.empty() ? info->name : info->name + ("." + suffix), image.values.data() + i, count});
    }
  }
  writeChannels(size, channels, file, session);
}

void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const fs::path& file,
              const std::string& session) {
  std::vector<ExrChannel> list;
  for (const FloatChannel& channel : channels) {
    if (channel.values.size() != volume::Extent2{size}.count())
      throw std::logic_error("writeExr: sizes differ");
    list.push_back({channel.name, channel.values.data(), 1});
  }
  writeChannels(size, list, file, session);
}

}  // namespace isolux::app
