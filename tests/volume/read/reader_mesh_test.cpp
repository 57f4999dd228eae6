// Mesh files: every format gives the same volume; broken ones give one line.
#include <cmath>
#include <random>

#include "tests/volume/mesh/mesh_shapes.h"
#include "tests/volume/read/reader_support.h"
#include "volume/read/mesh/mesh_formats.h"

namespace isolux {
namespace {

using volume::TriangleMesh;

struct Format {
  const char* name;
  std::string (*write)(const TriangleMesh&);
};
const Format formats[] = {
    {"m.obj", test::asObj},
    {"text.stl", test::asStlText},
    {"binary.stl", test::asStlBinary},
    {"text.ply", test::asPlyText},
    {"little.ply", [](const TriangleMesh& m) { return test::asPlyBinary(m, false); }},
    {"big.ply", [](const TriangleMesh& m) { return test::asPlyBinary(m, true); }},
    {"m.vtp", test::asVtp},
};

volume::ReadOptions coarse(int voxels = 16) {
  volume::ReadOptions options;
  options.meshVoxels = voxels;
  return options;
}

TEST(ReaderMesh, EveryFormatGivesTheSameVolume) {
  const auto folder = test::temporaryFolder();
  const TriangleMesh ball = test::icosphere(5.0, 2);
  std::vector<double> wanted;
  for (const Format& format : formats) {
    SCOPED_TRACE(format.name);
    test::writeFile(folder / format.name, format.write(ball));
    EXPECT_FALSE(volume::needsRawDescription(folder / format.name));
    const auto v = test::readFile(folder / format.name, coarse(24));
    EXPECT_THAT(v.format, testing::HasSubstr("mesh"));
    EXPECT_EQ(v.fileType, volume::VoxelType::float32);
    EXPECT_EQ(v.unit, "mm");
    EXPECT_THAT(v.warnings, testing::ElementsAre(testing::HasSubstr("1 unit = 1 mm")));
    const std::vector<double> values = test::valuesOf(v);
    if (wanted.empty()) wanted = values;
    EXPECT_THAT(values, testing::Pointwise(testing::DoubleNear(1e-5), wanted));
  }
}

TEST(ReaderMesh, ContentCountsBeforeTheName) {
  const auto folder = test::temporaryFolder();
  const TriangleMesh ball = test::icosphere(5.0, 1);
  test::writeFile(folder / "a.dat", test::asPlyText(ball));
  test::writeFile(folder / "b.dat", test::asStlText(ball));
  test::writeFile(folder / "c.vti", test::asVtp(ball));
  EXPECT_EQ(test::readFile(folder / "a.dat", coarse()).format, "PLY mesh");
  EXPECT_EQ(test::readFile(folder / "b.dat", coarse()).format, "STL mesh");
  EXPECT_EQ(test::readFile(folder / "c.vti", coarse()).format, "VTK PolyData mesh");
}

TEST(ReaderMesh, PolygonsNegativeIndicesAndContinuedLines) {
  const auto path = test::temporaryFolder() / "cube.obj";
  test::writeFile(path,
                  "v 0 0 0\nv 0 0 4\nv 0 4 0\nv 0 4 4\nv 4 0 0\nv 4 0 4\nv 4 4 0\nv 4 4 4\n"
                  "f 1 2 4 3 # a comment\nf -4 -2 -1 -3\nf 1 5 \\\n 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
  const auto v = test::readFile(path, coarse(24));
  EXPECT_THAT(v.warnings, testing::SizeIs(1));
  EXPECT_NEAR(v.grid->maximum(), 2.0, 0.3);
}

TEST(ReaderMesh, HolesAreSaidAndPlacesAreThoseOfTheFile) {
  const auto path = test::temporaryFolder() / "ball.ply";
  TriangleMesh ball = test::icosphere(5.0, 2, {100, -20, 30});
  ball.triangles.pop_back();
  test::writeFile(path, test::asPlyText(ball));
  const auto v = test::readFile(path, coarse(24));
  EXPECT_TRUE(test::warns(v, "holes"));
  const glm::dvec3 voxel(v.grid->geometry().voxelFromWorld() * glm::dvec4(100, -20, 30, 1));
  EXPECT_GT(v.grid->value(static_cast<int>(std::lround(voxel.x)), static_cast<int>(std::lround(voxel.y)),
                          static_cast<int>(std::lround(voxel.z))),
            4.0);
}

TEST(ReaderMesh, PolyDataStripsAndEncodings) {
  // A closed strip round a square bar, with its ends as polygons.
  const auto path = test::temporaryFolder() / "bar.vtp";
  test::writeFile(
      path,
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>"
      "<Piece NumberOfPoints=\"8\" NumberOfPolys=\"2\" NumberOfStrips=\"1\"><Points>"
      "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
      "0 0 0 0 0 9 3 0 0 3 0 9 3 3 0 3 3 9 0 3 0 0 3 9</DataArray></Points>"
      "<Strips><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5 6 7 0 1"
      "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">10</DataArray></Strips>"
      "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 2 4 6 7 5 3 1</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4 8</DataArray></Polys>"
      "</Piece></PolyData></VTKFile>");
  const auto v = test::readFile(path, coarse(32));
  EXPECT_FALSE(test::warns(v, "holes"));
  EXPECT_NEAR(v.grid->maximum(), 1.5, 0.25);
}

struct BrokenMesh {
  const char* what;
  const char* name;
  std::string content;
  const char* reason;
};

TEST(ReaderMesh, BrokenFilesAreRefusedWithOneLine) {
  const auto folder = test::temporaryFolder();
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto ply = [](const std::string& vertex, const std::string& face, const std::string& data,
                      const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertex +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + face +
           " vertex_indices\nend_header\n" + data;
  };
  const std::string list = "1\nproperty list uchar int";
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  const auto vtp = [](const std::string& count, const std::string& corners, const std::string& offsets) {
    return "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData><Piece "
           "NumberOfPoints=\"" +
           count +
           "\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
           "format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type=\"Int32\" "
           "Name=\"connectivity\" format=\"ascii\">" +
           corners + "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + offsets +
           "</DataArray></Polys></Piece></PolyData></VTKFile>";
  };
  std::string cutStl = test::asStlBinary(test::icosphere(1.0, 1));
  cutStl.resize(cutStl.size() - 10);
  std::string hugeStl(84, '\0');
  hugeStl.replace(80, 4, "\xff\xff\xff\xff");
  const BrokenMesh cases[] = {
      {"no faces", "a.obj", points, "no triangles"},
      {"index too large", "b.obj", points + "f 1 2 4\n", "line 4"},
      {"index far too large", "b2.obj", points + "f 1 2 99999999999\n", "names point"},
      {"index 0", "c.obj", points + "f 0 1 2\n", "names no point"},
      {"index before the first", "d.obj", points + "f -1 -2 -4\n", "names point -1"},
      {"two corners", "e.obj", points + "f 1 2\n", "fewer than three"},
      {"word", "f.obj", points + "v 1 two 3\n", "line 4"},
      {"nan", "g.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1"},
      {"infinite", "h.obj", "v 1e999 0 0\n", "not finite"},
      {"one point", "i.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "in one point"},
      {"rubbish", "j.obj", std::string(500, '\x01'), "no triangles"},
      {"stl cut", "k.stl", cutStl, "truncated: 80 facets are announced, the file holds 79"},
      {"stl claims 4e9 facets", "l.stl", hugeStl, "truncated"},
      {"stl short", "m.stl", "abc", "truncated"},
      {"stl text cut", "n.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "endsolid"},
      {"stl text with a word", "o.stl", "solid x\nfacet\nouter loop\nvertex 0 0 up\n", "line 4"},
      {"stl text rubbish", "p.stl", "solid x\nfacet\nhello\n", "\"hello\""},
      {"ply cut", "q.ply", ply("3", list, "0 0 0\n1 0 0\n"), "truncated"},
      {"ply claims", "r.ply", ply("4000000000", list, three), "truncated"},
      {"ply negative count", "s.ply", ply("-3", list, three), "no count"},
      {"ply negative list", "t.ply", ply("3", "1\nproperty list int int", three + "-3 0 1 2\n"), "length"},
      {"ply long list", "u.ply", ply("3", "1\nproperty list int int", three + "99999999 0 1 2\n"),
       "truncated"},
      {"ply index", "v.ply", ply("3", list, three + "3 0 1 3\n"), "names point 3"},
      {"ply type", "w.ply", ply("3", "1\nproperty list uchar quad", three), "quad"},
      {"ply format", "x.ply", ply("3", list, three, "utf8"), "utf8"},
      {"ply no header end", "y.ply", "ply\nformat ascii 1.0\n", "end_header"},
      {"ply without z", "z.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
       "has no property z"},
      {"vtp index", "a.vtp", vtp("3", "0 1 7", "3"), "names point 7"},
      {"vtp negative index", "b.vtp", vtp("3", "0 1 -1", "3"), "names point -1"},
      {"vtp offsets", "c.vtp", vtp("3", "0 1 2", "99"), "VTK cannot read it"},
      {"vtp negative offset", "c2.vtp", vtp("3", "0 1 2", "-3"), ""},
      {"vtp claims", "d.vtp", vtp("3000000000", "0 1 2", "3"), "too short for 3000000000"},
      {"vtp negative", "e.vtp", vtp("-1", "0 1 2", "3"), "is not a count"},
      {"vtp cut", "f.vtp", vtp("3", "0 1 2", "3").substr(0, 200), ""},
      {"vtp no piece", "g.vtp", "<VTKFile type=\"PolyData\"></VTKFile>", "Piece"},
  };
  for (const BrokenMesh& c : cases) {
    SCOPED_TRACE(c.what);
    test::writeFile(folder / c.name, c.content);
    test::expectError(folder / c.name, c.reason, coarse());
  }
}

// Any damage ends in a volume or in an Error, nothing else.
void expectSurvival(const std::filesystem::path& path, const std::string& content) {
  test::writeFile(path, content);
  base::Progress progress;
  try {
    const auto v = volume::readVolume(path.string(), coarse(), progress);
    EXPECT_TRUE(v.grid);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.file(), path.string());
    EXPECT_TRUE(error.kind() == base::ErrorKind::input || error.kind() == base::ErrorKind::memory);
  }
}

TEST(ReaderMesh, SurvivesTruncationAndDamage) {
  const auto folder = test::temporaryFolder();
  std::mt19937 random(11);
  for (const Format& format : formats) {
    SCOPED_TRACE(format.name);
    const std::string good = format.write(test::icosphere(5.0, 0));
    for (std::size_t length = 1; length < good.size(); length += 1 + good.size() / 40)
      expectSurvival(folder / format.name, good.substr(0, length));
    for (int i = 0; i < 60; ++i) {
      std::string bad = good;
      for (int k = 0; k < 3; ++k) bad[random() % bad.size()] = static_cast<char>(random());
      expectSurvival(folder / format.name, bad);
    }
  }
}

TEST(ReaderMesh, RespectsTheBudget) {
  const auto path = test::temporaryFolder() / "ball.ply";
  test::writeFile(path, test::asPlyText(test::icosphere(5.0, 1)));
  volume::ReadOptions options = coarse(64);
  options.budgetBytes = std::size_t{64} * 64 * 64;
  test::expectError(path, "mesh_voxels", options, base::ErrorKind::memory);
  options.budgetBytes = 1000;
  test::expectError(path, "memory budget", options, base::ErrorKind::memory);
}

}  // namespace
}  // namespace isolux
