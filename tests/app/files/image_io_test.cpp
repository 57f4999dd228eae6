#include "app/files/image_io.h"

#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include <sys/resource.h>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

render::LinearImage linearImage(glm::ivec2 size) {
  render::LinearImage image{size, {}};
  for (int i = 0; i < 4 * size.x * size.y; ++i) image.rgba.push_back(std::sin(0.37f * static_cast<float>(i)));
  return image;
}

render::ColorImage gradientImage(glm::ivec2 size) {
  render::ColorImage image{size, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const int value : {x * 7, y * 11, x + y, 255})
        image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

TEST(ImageIo, PngRoundTripsPixelsAndSession) {
  const fs::path file = test::temporaryFolder() / "a.png";
  const render::ColorImage image = gradientImage({31, 17});
  const std::string session = "{\"text\": \"ünï\\n\"}\n" + std::string(100000, ' ');
  writePng(image, file, session);
  const render::ColorImage back = test::readPng(file);
  EXPECT_EQ(back.size, image.size);
  EXPECT_EQ(back.rgba, image.rgba);
  EXPECT_EQ(readSessionText(file), session);
}

TEST(ImageIo, TheSamePictureIsTheSameFile) {
  const fs::path folder = test::temporaryFolder();
  writePng(gradientImage({8, 8}), folder / "a.png", "x");
  writePng(gradientImage({8, 8}), folder / "b.png", "x");
  EXPECT_EQ(test::contentOf(folder / "a.png"), test::contentOf(folder / "b.png"));
}

TEST(ImageIo, ExrHasNamedFloatChannels) {
  const fs::path file = test::temporaryFolder() / "a.exr";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const render::AovImage position{render::Aov::position, {2, 1}, 3, {1.5f, -2e-20f, 3e20f, nan, nan, nan}};
  const render::AovImage hit{render::Aov::hit, {2, 1}, 1, {1.0f, 0.0f}};
  writeExr(nullptr, {position, hit}, file, "session");

  const auto input = OIIO::ImageInput::open(file.string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  EXPECT_THAT(spec.channelnames,
              testing::UnorderedElementsAre("position.x", "position.y", "position.z", "hit"));
  EXPECT_EQ(spec.format, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT));
  EXPECT_EQ(spec.get_string_attribute("isolux_session"), "session");
  std::vector<float> values(8);
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, values.data()));
  const auto at = [&](int pixel, const char* channel) {
    return values[static_cast<std::size_t>(pixel * 4 + spec.channelindex(channel))];
  };
  EXPECT_EQ(at(0, "position.x"), 1.5f);
  EXPECT_EQ(at(0, "position.y"), -2e-20f);
  EXPECT_EQ(at(0, "position.z"), 3e20f);
  EXPECT_TRUE(std::isnan(at(1, "position.x")));
  EXPECT_EQ(at(0, "hit"), 1.0f);
  EXPECT_EQ(at(1, "hit"), 0.0f);
}

TEST(ImageIo, ExrColoursAreLinear) {
  const fs::path file = test::temporaryFolder() / "a.exr";
  const render::LinearImage image{{2, 1}, {0.0f, 1.0f, 0.1234567f, 1.0f, 7.5f, -1e-20f, 3e20f, 1.0f}};
  writeExr(&image, {}, file, "");
  const auto input = OIIO::ImageInput::open(file.string());
  ASSERT_TRUE(input);
  EXPECT_THAT(input->spec().channelnames, ElementsAre("R", "G", "B"));
  std::vector<float> values(6);
  ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data()));
  EXPECT_THAT(values, ElementsAre(0.0f, 1.0f, 0.1234567f, 7.5f, -1e-20f, 3e20f));  // as they are
}

// No file of this process may grow beyond `bytes` while one lives: as on a disk that fills up.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(ImageIo, ADiskThatFillsUpIsReportedToTheLastByte) {
  const fs::path folder = test::temporaryFolder();
  const render::ColorImage image = gradientImage({64, 64});
  const render::LinearImage linear = linearImage({64, 64});
  writePng(image, folder / "whole.png", "session");
  writeExr(&linear, {}, folder / "whole.exr", "session");
  const auto pngBytes = fs::file_size(folder / "whole.png"), exrBytes = fs::file_size(folder / "whole.exr");
  const auto refused = [](auto&& write) {
    try {
      write();
      return false;
    } catch (const base::Error& error) {
      return error.kind() == base::ErrorKind::input && !error.reason().empty();
    }
  };
  for (const std::uintmax_t missing : {1, 100, 700}) {
    const SmallDisk png(pngBytes - missing);
    EXPECT_TRUE(refused([&] { writePng(image, folder / "a.png", "session"); })) << missing;
    const SmallDisk exr(exrBytes - missing);
    EXPECT_TRUE(refused([&] { writeExr(&linear, {}, folder / "a.exr", "session"); })) << missing;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST(ImageIo, DamagedPngIsRefused) {
  const fs::path file = test::temporaryFolder() / "a.png";
  writePng(gradientImage({64, 48}), file, "");
  const std::string whole = test::contentOf(file);
  for (std::size_t length = 0; length + 12 < whole.size(); length += 7) {  // 12: what the end mark takes
    std::ofstream(file, std::ios::binary) << whole.substr(0, length);
    EXPECT_THROW(test::readPng(file), base::Error) << length;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    std::ofstream(file, std::ios::binary) << damaged;
    try {
      test::readPng(file);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::input) << at;
    }
  }
}

TEST(ImageIo, FailuresLeaveNothingBehind) {
  const fs::path folder = test::temporaryFolder();
  const render::ColorImage image = gradientImage({4, 4});
  EXPECT_THROW(writePng(image, folder / "no" / "a.png", ""), base::Error);
  EXPECT_THROW(writePng(image, folder, ""), base::Error);
  EXPECT_THROW(test::readPng(folder / "missing.png"), base::Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace isolux::app
