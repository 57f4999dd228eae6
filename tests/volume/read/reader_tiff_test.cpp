// TIFF pages and numbered files, written here directory by directory.
#include <cmath>
#include <map>

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
  std::uint16_t compression = 1, photometric = 1, planes = 1, orientation = 1, resolutionUnit = 2;
  double resolution = 0.0;                                          // pixels per unit; 0: not stated
  std::string description, noData, gdal;                            // "": no such tag
  std::vector<std::string> strips = {};                             // instead of `pixels`
  std::vector<std::pair<std::uint16_t, std::string>> records = {};  // other tags, of bytes
};

// Header, then for each page its pixels and its directory.
std::string tiff(const std::vector<Page>& pages, bool big = false) {
  const auto u16 = [&](std::uint16_t v) { return bytesOf<std::uint16_t>({v}, big); };
  const auto u32 = [&](std::uint32_t v) { return bytesOf<std::uint32_t>({v}, big); };
  std::string out = (big ? "MM" : "II") + u16(42);
  std::size_t link = out.size();
  out += u32(0);
  const auto append = [&](const std::string& bytes) {
    if (out.size() % 2) out += '\0';
    const auto at = static_cast<std::uint32_t>(out.size());
    out += bytes;
    return at;
  };
  for (const Page& page : pages) {
    const std::vector<std::string> strips =
        page.strips.empty() ? std::vector<std::string>{page.pixels} : page.strips;
    std::vector<std::uint32_t> starts, sizes;
    for (const std::string& strip : strips) {
      starts.push_back(append(strip));
      sizes.push_back(static_cast<std::uint32_t>(strip.size()));
    }
    std::map<std::uint16_t, std::string> entries;  // directories are sorted
    const auto entry = [&](std::uint16_t tag, std::uint16_t type, std::uint32_t count, std::string values) {
      if (values.size() > 4) values = u32(append(values));
      entries[tag] = u16(tag) + u16(type) + u32(count) + values + std::string(4 - values.size(), '\0');
    };
    const auto shortEntry = [&](std::uint16_t tag, std::uint16_t value) { entry(tag, 3, 1, u16(value)); };
    const auto longEntry = [&](std::uint16_t tag, std::uint32_t value) { entry(tag, 4, 1, u32(value)); };
    const auto textEntry = [&](std::uint16_t tag, const std::string& text) {
      if (!text.empty()) entry(tag, 2, static_cast<std::uint32_t>(text.size() + 1), text + '\0');
    };
    longEntry(254, page.kind);
    longEntry(256, page.width);
    longEntry(257, page.height);
    std::string bits;
    for (int i = 0; i < page.samples; ++i) bits += u16(page.bits);
    entry(258, 3, page.samples, bits);
    shortEntry(259, page.compression);
    shortEntry(262, page.samples >= 3 ? 2 : page.photometric);
    textEntry(270, page.description);
    entry(273, 4, static_cast<std::uint32_t>(starts.size()), bytesOf(starts, big));
    shortEntry(274, page.orientation);
    shortEntry(277, page.samples);
    longEntry(278, page.height);
    entry(279, 4, static_cast<std::uint32_t>(sizes.size()), bytesOf(sizes, big));
    if (page.resolution > 0.0) {
      const std::string ratio = u32(static_cast<std::uint32_t>(page.resolution * 1000)) + u32(1000);
      entry(282, 5, 1, ratio);
      entry(283, 5, 1, ratio);
    }
    shortEntry(284, page.planes);
    shortEntry(296, page.resolutionUnit);
    if (page.photometric == 3) entry(320, 3, 768, std::string(1536, '\x7f'));
    shortEntry(339, page.format);
    for (const auto& [tag, bytes] : page.records)
      entry(tag, 1, static_cast<std::uint32_t>(bytes.size()), bytes);
    textEntry(42112, page.gdal);
    textEntry(42113, page.noData);
    std::string directory = u16(static_cast<std::uint16_t>(entries.size()));
    for (const auto& [tag, bytes] : entries) directory += bytes;
    out.replace(link, 4, u32(append(directory)));
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
  EXPECT_TRUE(test::warns(v, "1 of 3 pages differ"));
}

TEST(Tiff, MostPagesDecideWhichAreKept) {
  const auto path = test::temporaryFolder() / "stack.tif";
  Page label = page(50);
  label.width = 2;
  writeFile(path, tiff({label, page(0), page(6)}));
  const auto v = readFile(path);
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 2));
  EXPECT_EQ(v.grid->value(0, 0, 1), 6.0);
}

// Numbers of `bits` bits, the highest first; rows begin at bytes.
std::string packed(const std::vector<int>& numbers, int bits, std::size_t perRow) {
  std::string out;
  for (std::size_t row = 0; row < numbers.size(); row += perRow) {
    std::string digits;
    for (std::size_t i = row; i < row + perRow; ++i)
      for (int bit = bits; bit-- > 0;) digits += (numbers[i] >> bit & 1) ? '1' : '0';
    digits.resize((digits.size() + 7) / 8 * 8, '0');
    for (std::size_t i = 0; i < digits.size(); i += 8)
      out += static_cast<char>(std::stoi(digits.substr(i, 8), nullptr, 2));
  }
  return out;
}

TEST(Tiff, NumbersOfAnyLengthAreTakenAsStored) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const int bits : {1, 4, 10, 12, 14, 20})
    for (const bool isSigned : {false, true}) {
      SCOPED_TRACE(std::to_string(bits) + (isSigned ? " signed" : ""));
      if (bits == 1 && isSigned) continue;
      const int top = static_cast<int>((std::int64_t{1} << (bits - (isSigned ? 1 : 0))) - 1);
      const std::vector<int> numbers = {0, 1, top, top / 2, isSigned ? -1 : top, isSigned ? -top : 0};
      Page p;
      p.bits = static_cast<std::uint16_t>(bits);
      p.format = isSigned ? 2 : 1;
      p.pixels = packed(numbers, bits, 3);
      writeFile(path, tiff({p}, isSigned));  // the byte order is not that of packed bits
      EXPECT_EQ(valuesOf(readFile(path)), std::vector<double>(numbers.begin(), numbers.end()));
    }
  Page p;
  p.bits = 24;
  p.pixels = std::string("\1\0\0\0\1\0\0\0\1\xff\xff\xff\0\0\0\2\0\0", 18);
  writeFile(path, tiff({p}));
  EXPECT_THAT(valuesOf(readFile(path)), testing::ElementsAre(1, 256, 65536, 16777215, 0, 2));
  p.format = 2;
  writeFile(path, tiff({p}));
  EXPECT_EQ(valuesOf(readFile(path))[3], -1.0);
}

TEST(Tiff, HalfAndComplexNumbers) {
  const auto path = test::temporaryFolder() / "stack.tif";
  Page p;
  p.bits = 16;
  p.format = 3;
  p.pixels = bytesOf<std::uint16_t>({0x3c00, 0xc000, 0x3800, 0x0001, 0x7c00, 0x7bff});
  writeFile(path, tiff({p}));
  const auto v = readFile(path);
  EXPECT_EQ(v.grid->value(1, 0, 0), -2.0);
  EXPECT_EQ(v.grid->value(2, 0, 0), 0.5);
  EXPECT_EQ(v.grid->value(0, 1, 0), std::ldexp(1.0, -24));
  EXPECT_EQ(v.grid->missingCount(), 1u);
  EXPECT_EQ(v.grid->value(2, 1, 0), 65504.0);
  p.bits = 64;
  p.format = 6;
  p.pixels = bytesOf<float>({3, 4, 1, 0, 0, 1, 6, 8, 0, 0, 5, 12});
  writeFile(path, tiff({p}));
  volume::ReadOptions options;
  options.component = -1;
  EXPECT_THAT(valuesOf(readFile(path, options)), testing::ElementsAre(5, 1, 1, 10, 0, 13));
}

TEST(Tiff, WhatIsWhiteAndPalettesDoNotChangeNumbers) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const std::uint16_t photometric : {std::uint16_t{0}, std::uint16_t{3}}) {
    Page p = page(10);
    p.photometric = photometric;
    writeFile(path, tiff({p}));
    const auto v = readFile(path);
    EXPECT_EQ(v.components, 1);
    EXPECT_THAT(valuesOf(v), testing::ElementsAre(10, 11, 12, 13, 14, 15));
    EXPECT_TRUE(test::warns(v, photometric == 0 ? "MinIsWhite" : "palette"));
  }
  for (const std::uint16_t photometric : {std::uint16_t{6}, std::uint16_t{32845}}) {
    Page p = page(0);
    p.photometric = photometric;
    writeFile(path, tiff({p}));
    expectError(path, photometric == 6 ? "YCbCr" : "LogLuv");
  }
  Page turned = page(0);
  turned.orientation = 3;
  writeFile(path, tiff({turned}));
  EXPECT_TRUE(test::warns(readFile(path), "Orientation 3"));
}

TEST(Tiff, PlanesOfColourPackedOrNot) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const bool deflated : {false, true}) {
    Page p;
    p.samples = 3;
    p.planes = 2;
    p.compression = deflated ? 8 : 1;
    for (std::uint8_t plane = 0; plane < 3; ++plane) {
      const std::string bytes = bytesOf(test::ramp<std::uint8_t>(6, static_cast<std::uint8_t>(10 * plane)));
      p.strips.push_back(deflated ? test::zlibbed(bytes) : bytes);
    }
    writeFile(path, tiff({p}));
    volume::ReadOptions options;
    options.component = 2;
    const auto v = readFile(path, options);
    EXPECT_EQ(v.components, 3);
    EXPECT_THAT(valuesOf(v), testing::ElementsAre(20, 21, 22, 23, 24, 25));
  }
}

TEST(Tiff, ManyPagesTakeTimeInProportion) {
  const auto path = test::temporaryFolder() / "stack.tif";
  Page p;
  p.width = p.height = 2;
  p.pixels = "abcd";
  writeFile(path,
            tiff(std::vector<Page>(20000, p)));  // a minute and more where each page starts at the first
  EXPECT_EQ(readFile(path).grid->dims().z, 20000);
}

// --- what the description says

std::vector<Page> numbered(int count) {
  std::vector<Page> pages;
  for (int i = 0; i < count; ++i) pages.push_back(page(static_cast<std::uint8_t>(6 * i)));
  return pages;
}

std::vector<double> firstOfSlices(const volume::Volume& v) {
  std::vector<double> values;
  for (int z = 0; z < v.grid->dims().z; ++z) values.push_back(v.grid->value(0, 0, z));
  return values;
}

volume::Volume readTold(const std::string& description, int count, const volume::ReadOptions& options = {},
                        double resolution = 4.0, std::uint16_t unit = 1) {
  const auto path = test::temporaryFolder() / "told.tif";
  std::vector<Page> pages = numbered(count);
  pages[0].description = description;
  pages[0].resolution = resolution;
  pages[0].resolutionUnit = unit;
  writeFile(path, tiff(pages));
  return readFile(path, options);
}

TEST(Tiff, ImageJHyperstack) {
  const std::string hyperstack =
      "ImageJ=1.53c\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nunit=micron\nspacing=0.5\n";
  volume::ReadOptions options;
  options.component = 1;
  options.timeStep = 1;
  const auto v = readTold(hyperstack, 12, options);
  EXPECT_EQ(v.components, 2);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 3));
  EXPECT_THAT(firstOfSlices(v), testing::ElementsAre(42, 54, 66));  // pages 7, 9, 11
  test::expectNear(v.grid->geometry().spacingMm(), {0.00025, 0.00025, 0.0005}, 1e-12);
  EXPECT_FALSE(test::warns(v, "assumed"));
  options.component = -1;
  options.timeStep = 0;
  EXPECT_NEAR(readTold(hyperstack, 12, options).grid->value(0, 0, 1), std::hypot(12.0, 18.0), 1e-5);
  options.component = 2;
  EXPECT_THROW(readTold(hyperstack, 12, options), base::Error);
}

TEST(Tiff, ImageJUnits) {
  const std::string start = "ImageJ=1.53c\nimages=2\nslices=2\n";
  const auto spacing = [](const volume::Volume& v) { return v.grid->geometry().spacingMm(); };
  test::expectNear(spacing(readTold(start + "unit=\\u00B5m\nspacing=2\n", 2)), {0.00025, 0.00025, 0.002},
                   1e-12);
  test::expectNear(spacing(readTold(start + "unit=mm\nspacing=2\n", 2)), {0.25, 0.25, 2});
  test::expectNear(spacing(readTold(start + "unit=um\nspacing=2\n", 2, {}, 40000, 3)),
                   {0.00025, 0.00025, 0.002}, 1e-12);
  EXPECT_TRUE(test::warns(readTold(start + "unit=um\nspacing=2\n", 2, {}, 4, 2), "ResolutionUnit says inch"));
  EXPECT_TRUE(test::warns(readTold(start + "unit=um\n", 2), "assumed as the distance of slices"));
  EXPECT_TRUE(test::warns(readTold(start + "unit=furlong\nspacing=2\n", 2), "1 mm assumed"));
  EXPECT_TRUE(test::warns(readTold(start + "spacing=2\n", 2), "1 mm assumed"));
  EXPECT_TRUE(test::warns(readTold(start, 2, {}, 300, 2), "300 x 300 pixels per inch"));
  EXPECT_TRUE(test::warns(readTold(start, 2), "1 mm assumed"));
}

TEST(Tiff, ImageJStackInOnePage) {
  const auto path = test::temporaryFolder() / "stack.tif";
  for (const bool big : {false, true}) {
    Page p;
    p.bits = 16;
    p.pixels = bytesOf(test::ramp<std::uint16_t>(6), big);
    p.description = "ImageJ=1.53c\nimages=3\nslices=3\nunit=mm\nspacing=1\n";
    const std::string rest = bytesOf(test::ramp<std::uint16_t>(12, 6), big);
    // The pixels of all planes follow one another: the directory is moved behind them.
    std::string bytes = tiff({p}, big);
    p.strips = {p.pixels + rest};
    bytes = tiff({p}, big);
    const std::string all = bytesOf<std::uint32_t>({36}, big), one = bytesOf<std::uint32_t>({12}, big);
    const std::size_t counts = bytes.find(bytesOf<std::uint16_t>({279, 4}, big));
    ASSERT_EQ(bytes.substr(counts + 8, 4), all);
    bytes.replace(counts + 8, 4, one);
    writeFile(path, bytes);
    const auto v = readFile(path);
    EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 3));
    const auto values = valuesOf(v);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], static_cast<double>(i));
  }
  Page p = page(0);
  p.description = "ImageJ=1.53c\nimages=3000\nslices=3000\n";
  writeFile(path, tiff({p}));
  expectError(path, "announces 3000 images");
  p.compression = 8;
  p.pixels = test::zlibbed(p.pixels);
  writeFile(path, tiff({p}));
  expectError(path, "announces 3000 images");
}

TEST(Tiff, ImageJCalibration) {
  const std::string start = "ImageJ=1.53c\nimages=2\nslices=2\nunit=mm\nspacing=1\n";
  const auto signedOf = readTold(start + "cf=0\nc0=-32768.0\nc1=1.0\nvunit=gray value\n", 2);
  EXPECT_THAT(firstOfSlices(signedOf), testing::ElementsAre(-32768, -32762));
  EXPECT_EQ(signedOf.unit, "");
  const auto scaled = readTold(start + "cf=0\nc0=-1\nc1=0.5\nvunit=Bq/ml\n", 2);
  EXPECT_THAT(firstOfSlices(scaled), testing::ElementsAre(-1, 2));
  EXPECT_EQ(scaled.unit, "Bq/ml");
  EXPECT_TRUE(test::warns(readTold(start + "cf=3\nc0=-1\nc1=0.5\n", 2), "calibration function"));
}

TEST(Tiff, DescriptionsThatThePagesContradict) {
  EXPECT_TRUE(test::warns(readTold("ImageJ=1.53c\nimages=8\nslices=8\n", 4), "announces 8 images"));
  EXPECT_TRUE(test::warns(readTold("ImageJ=1.53c\nimages=4\nchannels=3\nslices=4\n", 4), "3 channels"));
  EXPECT_EQ(readTold("ImageJ=1.53c\nimages=4\nframes=4\n", 4).timeSteps, 4);
  EXPECT_EQ(readTold("ImageJ=1.53c\nimages=4\nchannels=2\n", 4).grid->dims().z, 2);
  EXPECT_THROW(readTold("ImageJ=1.53c\nimages=4\nchannels=-2\n", 4), base::Error);
}

std::string ome(const std::string& order, const std::string& more, const std::string& data = "<TiffData/>") {
  return "<?xml version=\"1.0\"?><!-- a comment --><OME><Image ID=\"Image:0\"><Pixels DimensionOrder=\"" +
         order + "\" SizeX=\"3\" SizeY=\"2\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\" Type=\"uint8\" " + more +
         "><Channel ID=\"C:0\"/><Channel ID=\"C:1\"/>" + data + "</Pixels></Image></OME>";
}
const std::string kSizes = "PhysicalSizeX=\"0.25\" PhysicalSizeY=\"0.25\" PhysicalSizeZ=\"0.5\"";

TEST(Tiff, OmeXml) {
  volume::ReadOptions second;
  second.component = 1;
  const auto interleaved = readTold(ome("XYCZT", kSizes), 6, second);
  EXPECT_EQ(interleaved.components, 2);
  EXPECT_THAT(firstOfSlices(interleaved), testing::ElementsAre(6, 18, 30));
  test::expectNear(interleaved.grid->geometry().spacingMm(), {0.00025, 0.00025, 0.0005}, 1e-12);
  EXPECT_THAT(firstOfSlices(readTold(ome("XYZCT", kSizes), 6, second)), testing::ElementsAre(18, 24, 30));
  const std::string reversed =
      "<TiffData IFD=\"5\"/><TiffData IFD=\"4\" FirstZ=\"1\"/><TiffData IFD=\"3\" FirstZ=\"2\"/>"
      "<TiffData IFD=\"0\" FirstC=\"1\" PlaneCount=\"3\"/>";
  EXPECT_THAT(firstOfSlices(readTold(ome("XYZCT", kSizes, reversed), 6)), testing::ElementsAre(30, 24, 18));
  EXPECT_THAT(firstOfSlices(readTold(ome("XYZCT", kSizes, reversed), 6, second)),
              testing::ElementsAre(0, 6, 12));
  const auto nm = readTold(ome("XYZCT", kSizes + " PhysicalSizeZUnit=\"nm\""), 6);
  EXPECT_NEAR(nm.grid->geometry().spacingMm().z, 5e-7, 1e-15);
  EXPECT_TRUE(test::warns(readTold(ome("XYZCT", "PhysicalSizeX=\"1\" PhysicalSizeY=\"1\""), 6),
                          "as the distance of slices"));
  EXPECT_TRUE(test::warns(readTold(ome("XYZCT", ""), 6), "1 mm assumed"));
  EXPECT_TRUE(test::warns(readTold(ome("XYZCT", kSizes), 7), "1 pages belong to no plane"));
}

TEST(Tiff, OmeXmlThatDoesNotFit) {
  const auto path = test::temporaryFolder() / "told.tif";
  const auto refuse = [&](const std::string& xml, int pages, const std::string& reason) {
    std::vector<Page> all = numbered(pages);
    all[0].description = xml;
    writeFile(path, tiff(all));
    expectError(path, reason);
  };
  refuse(ome("XYZCT", kSizes), 5, "the file has 5 pages");
  refuse(ome("XYZZT", kSizes), 6, "DimensionOrder");
  refuse(ome("XYZCT", kSizes, "<TiffData IFD=\"9\" PlaneCount=\"6\"/>"), 6, "names no page");
  refuse(ome("XYZCT", kSizes,
             "<TiffData IFD=\"0\"><UUID FileName=\"told.tif\"/></TiffData>"
             "<TiffData IFD=\"0\" FirstZ=\"1\"><UUID FileName=\"other.tif\"/></TiffData>"),
         1, "others are in other.tif");
  refuse("<OME><Image><Pixels SizeX=\"3", 1, "OME-XML");
  EXPECT_TRUE(test::warns(readTold("<OME><BinaryOnly MetadataFile=\"a.companion.ome\"/></OME>", 2),
                          "a.companion.ome"));
}

TEST(Tiff, ShapesOfTifffile) {
  volume::ReadOptions second;
  second.timeStep = 1;
  const auto v = readTold("{\"shape\": [2, 3, 2, 3], \"axes\": \"TZYX\"}", 6, second);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_THAT(firstOfSlices(v), testing::ElementsAre(18, 24, 30));
  EXPECT_TRUE(test::warns(readTold("{\"shape\": [2, 3, 2, 3]}", 6), "whose axes are not known"));
}

TEST(Tiff, ZeissLsm) {
  std::string record(64, '\0');
  const auto put = [&](std::size_t at, auto value) {
    record.replace(at, sizeof value, bytesOf(std::vector{value}));
  };
  put(16, std::int32_t{2});
  put(20, std::int32_t{1});
  put(24, std::int32_t{3});
  for (std::size_t axis = 0; axis < 3; ++axis) put(40 + 8 * axis, 1e-6 * static_cast<double>(axis + 1));
  const auto path = test::temporaryFolder() / "stack.tif";
  std::vector<Page> pages = numbered(6);
  pages[0].records = {{std::uint16_t{34412}, record}};
  writeFile(path, tiff(pages));
  const auto v = readFile(path);
  EXPECT_EQ(v.timeSteps, 3);
  EXPECT_EQ(v.grid->dims().z, 2);
  test::expectNear(v.grid->geometry().spacingMm(), {0.001, 0.002, 0.003}, 1e-12);
}

TEST(Tiff, NoDataScaleAndOthersRecords) {
  const auto path = test::temporaryFolder() / "stack.tif";
  Page p = page(0);
  p.noData = "2";
  p.gdal =
      "<GDALMetadata><Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>"
      "<Item name=\"OFFSET\" sample=\"0\" role=\"offset\">10</Item></GDALMetadata>";
  p.records = {{std::uint16_t{33550}, std::string(24, '\1')}};
  writeFile(path, tiff({p}));
  const auto v = readFile(path);
  EXPECT_EQ(v.grid->missingCount(), 1u);
  EXPECT_EQ(v.grid->value(1, 0, 0), 10.5);
  EXPECT_TRUE(test::warns(v, "no-data value"));
  EXPECT_TRUE(test::warns(v, "GeoTIFF"));
}

TEST(Tiff, AFolderOfFilesWithStatements) {
  const auto folder = test::temporaryFolder() / "stack";
  std::filesystem::create_directories(folder);
  for (int i : {1, 2}) {
    Page p = page(static_cast<std::uint8_t>(i));
    p.description = "ImageJ=1.53c\nunit=um\n";
    p.resolution = 4;
    p.resolutionUnit = 1;
    writeFile(folder / ("s" + std::to_string(i) + ".tif"), tiff({p}));
  }
  const auto v = readFile(folder);
  EXPECT_NEAR(v.grid->geometry().spacingMm().x, 0.00025, 1e-12);
  EXPECT_TRUE(test::warns(v, "assumed as the distance of slices"));
  std::vector<Page> channels = numbered(2);
  channels[0].description = "ImageJ=1.53c\nimages=2\nchannels=2\n";
  writeFile(folder / "s1.tif", tiff(channels));
  expectError(folder, "open one of them");
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
