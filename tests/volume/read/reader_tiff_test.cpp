// TIFF pages and numbered files, written here directory by directory.
#include "tests/volume/read/reader_support.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux {
namespace {

using test::bytesOf;
using test::expectError;
using test::readFile;
using test::valuesOf;
using test::writeFile;

struct Page {
  std::uint32_t width = 3, height = 2;
  std::uint16_t bits = 8, samples = 1, format = 1;  // 1 unsigned, 2 signed, 3 float
  std::uint32_t kind = 0;
  std::string pixels;
};

// Header, then for each page its pixels and its directory.
std::string tiff(const std::vector<Page>& pages, bool big = false) {
  const auto u16 = [&](std::uint16_t v) { return bytesOf<std::uint16_t>({v}, big); };
  const auto u32 = [&](std::uint32_t v) { return bytesOf<std::uint32_t>({v}, big); };
  std::string out = (big ? "MM" : "II") + u16(42);
  std::size_t link = out.size();
  out += u32(0);
  for (const Page& page : pages) {
    const auto pixelsAt = static_cast<std::uint32_t>(out.size());
    out += page.pixels;
    if (out.size() % 2) out += '\0';
    std::string entries;
    std::uint16_t count = 0;
    const auto entry = [&](std::uint16_t tag, bool isLong, std::uint32_t value) {
      entries += u16(tag) + u16(isLong ? 4 : 3) + u32(1) +
                 (isLong ? u32(value) : u16(static_cast<std::uint16_t>(value)) + u16(0));
      ++count;
    };
    entry(254, true, page.kind);
    entry(256, true, page.width);
    entry(257, true, page.height);
    entry(258, false, page.bits);  // the same for all samples: one value is enough for readers here
    entry(259, false, 1);
    entry(262, false, page.samples >= 3 ? 2 : 1);
    entry(273, true, pixelsAt);
    entry(277, false, page.samples);
    entry(278, true, page.height);
    entry(279, true, static_cast<std::uint32_t>(page.pixels.size()));
    entry(339, false, page.format);
    out.replace(link, 4, u32(static_cast<std::uint32_t>(out.size())));
    out += u16(count) + entries;
    link = out.size();
    out += u32(0);
  }
  return out;
}

Page page(std::uint8_t first) {
  Page p;
  p.pixels = bytesOf(test::ramp<std::uint8_t>(6, first));
  return p;
}

TEST(Tiff, PagesOfOneFile) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const bool big : {false, true}) {
    writeFile(path, tiff({page(0), page(6), page(12)}, big));
    const auto v = readFile(path);
    EXPECT_EQ(v.format, "TIFF");
    EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 3));
    const auto values = valuesOf(v);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], static_cast<double>(i));
    EXPECT_TRUE(test::warns(v, "1 mm assumed"));
    EXPECT_EQ(v.axes, scene::WorldAxes::zUp);
  }
}

TEST(Tiff, SixteenBitAndFloat) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const bool big : {false, true}) {
    Page p;
    p.bits = 16;
    p.pixels = bytesOf(test::ramp<std::uint16_t>(6, 1000, 10000), big);
    writeFile(path, tiff({p}, big));
    EXPECT_EQ(valuesOf(readFile(path))[5], 51000.0);
    p.format = 2;
    p.pixels = bytesOf(test::ramp<std::int16_t>(6, -1000, 100), big);
    writeFile(path, tiff({p}, big));
    EXPECT_EQ(valuesOf(readFile(path))[0], -1000.0);
    p.bits = 32;
    p.format = 3;
    p.pixels = bytesOf(test::ramp<float>(6, -0.5f, 0.25f), big);
    writeFile(path, tiff({p}, big));
    const auto v = readFile(path);
    EXPECT_EQ(v.fileType, volume::VoxelType::float32);
    EXPECT_EQ(valuesOf(v)[5], 0.75);
  }
}

TEST(Tiff, FolderInNaturalOrder) {
  const auto folder = test::temporaryFolder() / "stack";
  std::filesystem::create_directories(folder);
  for (int i : {1, 2, 10})
    writeFile(folder / ("s" + std::to_string(i) + ".tif"), tiff({page(static_cast<std::uint8_t>(i))}));
  const auto v = readFile(folder);
  EXPECT_EQ(v.grid->dims().z, 3);
  EXPECT_EQ(v.grid->value(0, 0, 0), 1.0);
  EXPECT_EQ(v.grid->value(0, 0, 1), 2.0);
  EXPECT_EQ(v.grid->value(0, 0, 2), 10.0);
}

TEST(Tiff, NaturalOrder) {
  EXPECT_TRUE(volume::naturalLess("a2", "a10"));
  EXPECT_FALSE(volume::naturalLess("a10", "a2"));
  EXPECT_TRUE(volume::naturalLess("a02b1", "a2b3"));
  EXPECT_TRUE(volume::naturalLess("a", "a1"));
  EXPECT_FALSE(volume::naturalLess("a1", "a1"));
  EXPECT_TRUE(volume::naturalLess("a99999999999999999999998", "a99999999999999999999999"));
  EXPECT_NE(volume::naturalLess("a01", "a1"), volume::naturalLess("a1", "a01"));
}

TEST(Tiff, ThumbnailsAndOddPagesAreLeftOut) {
  const auto path = test::temporaryFolder() / "stack.tif";
  Page thumbnail = page(99), odd = page(50);
  thumbnail.kind = 1;
  odd.width = 2;
  writeFile(path, tiff({page(0), thumbnail, odd, page(6)}));
  const auto v = readFile(path);
  EXPECT_EQ(v.grid->dims().z, 2);
  EXPECT_EQ(v.grid->value(0, 0, 1), 6.0);
  EXPECT_TRUE(test::warns(v, "1 pages differ"));
}

TEST(Tiff, BrokenFiles) {
  const auto path = test::temporaryFolder() / "stack.tif";
  const std::string good = tiff({page(0)});
  const auto refuse = [&](const std::string& bytes, const std::string& reason) {
    writeFile(path, bytes);
    expectError(path, reason);
  };
  refuse(good.substr(0, 20), "truncated");
  refuse(good.substr(0, 8), "truncated");
  refuse(good.substr(0, 4) + bytesOf<std::uint32_t>({0xfffffff0u}) + good.substr(8), "truncated");
  refuse(good.substr(0, 4) + bytesOf<std::uint32_t>({0}) + good.substr(8), "no page");
  Page huge = page(0);
  huge.width = huge.height = 60000;
  refuse(tiff({huge}), "truncated");
  huge.width = 1000000;
  refuse(tiff({huge}), "65535");
  huge.width = 0;
  refuse(tiff({huge}), "pixels");
  std::string circle = good;
  circle.replace(circle.size() - 4, 4, circle.substr(4, 4));
  refuse(circle, "circle");
  std::string far = good;  // the strip lies behind the end
  const std::size_t at = far.find(bytesOf<std::uint16_t>({273}));
  far.replace(at + 8, 4, bytesOf<std::uint32_t>({0x00ffffff}));
  testing::internal::CaptureStderr();
  refuse(far, "truncated: strip 1");
  std::string rubbish = good;  // said to be deflated
  const std::size_t compression = rubbish.find(bytesOf<std::uint16_t>({259, 3}));
  rubbish.replace(compression + 8, 2, bytesOf<std::uint16_t>({8}));
  refuse(rubbish, "page 1");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace isolux
