// The PNG files of image_io.h, by libpng.
#include "app/files/image_io.h"

#include <csetjmp>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <new>

#include <png.h>

#include "base/error.h"
#include "base/pending_file.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

// Everything a writer holds, so that the function that libpng leaves by longjmp has nothing to destroy.
struct PngWriter {
  using Sink = std::function<void(std::string_view bytes)>;

  Sink sink;
  png_structp png = nullptr;
  png_infop info = nullptr;
  const std::vector<std::pair<std::string, std::string>> texts;
  std::vector<png_text> chunks;
  std::string failure = "libpng cannot be set up";
  std::exception_ptr thrown;  // by the sink

  PngWriter(Sink to, const std::string& session) : sink(std::move(to)), texts(pictureTexts(session)) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, failed, [](png_structp, png_const_charp) {});
    info = png ? png_create_info_struct(png) : nullptr;
    for (const auto& [keyword, text] : texts) {
      png_text chunk{};
      chunk.compression = PNG_TEXT_COMPRESSION_NONE;
      chunk.key = const_cast<char*>(keyword.c_str());  // libpng only reads them
      chunk.text = const_cast<char*>(text.c_str());
      chunk.text_length = text.size();
      chunks.push_back(chunk);
    }
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  static void put(png_structp png, png_bytep bytes, std::size_t count) {
    auto& self = *static_cast<PngWriter*>(png_get_io_ptr(png));
    try {
      self.sink({reinterpret_cast<const char*>(bytes), count});
    } catch (...) {
      self.thrown = std::current_exception();
    }
    if (self.thrown) png_error(png, "not written");
  }

 private:
  static void failed(png_structp png, png_const_charp message) {
    static_cast<PngWriter*>(png_get_error_ptr(png))->failure = message;
    png_longjmp(png, 1);
  }
};

// False after an error. No object with a destructor may live in here.
bool encode(PngWriter& writer, const render::ColorImage& image) {
  const png_structp png = writer.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &writer, PngWriter::put, [](png_structp) {});
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.size.x),
               static_cast<png_uint_32>(image.size.y), 8,
               image.transparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 4);  // a third of the time of zlib's 6, for 8 % more bytes
  png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (!writer.chunks.empty())
    png_set_text(png, writer.info, writer.chunks.data(), static_cast<int>(writer.chunks.size()));
  png_write_info(png, writer.info);
  if (!image.transparent) png_set_filler(png, 0, PNG_FILLER_AFTER);  // the fourth byte of a pixel is skipped
  for (int y = 0; y < image.size.y; ++y)
    png_write_row(png, image.rgba.data() + 4 * volume::Extent2{image.size}.index(0, y));
  png_write_end(png, nullptr);
  return true;
}

// Throws what `sink` throws; Error{input} naming `file` where libpng fails.
void encodeInto(PngWriter::Sink sink, const render::ColorImage& image, const std::string& session,
                const std::string& file) {
  PngWriter writer(std::move(sink), session);
  if (writer.info && encode(writer, image)) return;
  if (writer.thrown) std::rethrow_exception(writer.thrown);
  throwInput(file, "", "cannot be written: " + writer.failure);
}

}  // namespace

void writePng(const render::ColorImage& image, const fs::path& file, const std::string& session) {
  base::OutputFile output(file);
  encodeInto([&](std::string_view bytes) { output.write(bytes); }, image, session, file.string());
  output.commit();
}

std::string pngBytes(const render::ColorImage& image, const std::string& session) {
  std::string all;
  try {
    encodeInto([&](std::string_view bytes) { all += bytes; }, image, session, "");
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, "", "", "no memory for the bytes of a picture");
  }
  return all;
}

}  // namespace isolux::app
