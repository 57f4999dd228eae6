// isolux measure and isolux probe: what they print, and what they refuse.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

constexpr double kBallRadius = 0.35 * 63.0;  // phantom:ball:64, voxels of 1 mm about the world's origin

json jsonOf(const std::vector<std::string>& arguments, const fs::path& folder = temporaryFolder()) {
  const RunResult result = callIsolux(arguments, folder);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return json::parse(result.out);
}

// One line on stderr with these words, nothing on stdout.
void expectRefused(int exitCode, const std::vector<std::string>& arguments, const std::string& words,
                   const fs::path& folder = temporaryFolder()) {
  const RunResult result = callIsolux(arguments, folder);
  EXPECT_EQ(result.exitCode, exitCode) << testing::PrintToString(arguments) << result.err;
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  EXPECT_THAT(result.err, HasSubstr(words));
  EXPECT_EQ(result.out, "");
}

void expectWithinError(const json& measured, double reference) {
  EXPECT_LE(std::abs(measured["value"].get<double>() - reference), measured["error"].get<double>())
      << measured;
}

// What knows whole isosurfaces only says so, and how to have one; cuts that touch nothing are none.
TEST(MeasureCommand, CutsAreRefusedWithTheWayOut) {
  const std::string plane = "clip.planes=0,0,0 0,0,1", box = "clip.box=-5,-5,-5; 5,5,5",
                    corner = "clip.removed=0,0,0; 9,9,9";
  const std::vector<std::vector<std::string>> commands = {{"measure", "phantom:ball:24"},
                                                          {"mesh", "phantom:ball:24", "--out", "ball.stl"},
                                                          {"study", "phantom:ball:24", "--out", "study"}};
  for (const std::vector<std::string>& command : commands)
    for (const auto& [cut, setting] :
         {std::pair{plane, "clip.planes"}, std::pair{box, "clip.box"}, std::pair{corner, "clip.removed"}}) {
      std::vector<std::string> words = command;
      words.insert(words.end(), {"--set", cut});
      expectRefused(2, words, "isosurface.clipped=false");
      expectRefused(2, words, setting);
    }
  const json whole = jsonOf({"measure", "phantom:ball:24", "--json"});
  const json told =
      jsonOf({"measure", "phantom:ball:24", "--json", "--set", plane, "--set", "isosurface.clipped=false"});
  EXPECT_EQ(told["area_mm2"], whole["area_mm2"]);
  EXPECT_EQ(told["volume_mm3"], whole["volume_mm3"]);
}

TEST(MeasureCommand, TheCurvatureOfAPieceIsToldTabledAndPlotted) {
  const fs::path folder = temporaryFolder();
  const json ball = jsonOf({"measure", "phantom:ball:64", "--json", "--histograms", "ball.csv", "--plot",
                            "ball.svg", "--piece", "0", "--set", "derivatives.noise=0"},
                           folder)["curvature"];
  const double radius = kBallRadius, pi = std::numbers::pi;
  EXPECT_NEAR(ball["gaussian_curvature_integral"].get<double>(), 4.0 * pi, 0.1);
  EXPECT_NEAR(ball["measures"]["kappa1"]["quantiles"]["median"].get<double>() * radius, 1.0, 0.01);
  EXPECT_EQ(ball["clear_area_mm2"], ball["area_mm2"]);
  std::ifstream table(folder / "ball.csv");
  std::string line;
  ASSERT_TRUE(std::getline(table, line));
  EXPECT_EQ(line, "measure,unit,low,high,area_mm2,clear_area_mm2");
  double area = 0.0;
  while (std::getline(table, line)) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    ASSERT_GE(words.size(), 5u) << line;
    if (words[0] == "kappa2") area += std::stod(words[4]);
  }
  EXPECT_NEAR(area, ball["area_mm2"].get<double>(), 1e-6 * area);
  EXPECT_GT(fs::file_size(folder / "ball.svg"), 4000u);
  EXPECT_FALSE(fs::exists(folder / "ball.gp"));
}

TEST(MeasureCommand, AsksForWhatIsThereOfCurvature) {
  expectRefused(2, {"measure", "phantom:ball:16", "--curvature", "--piece", "1"}, "unknown piece 1");
  expectRefused(2, {"measure", "phantom:ball:16", "--piece", "0"}, "--curvature");
  expectRefused(2, {"measure", "phantom:ball:16", "--histograms", "a.txt"}, ".csv");
  expectRefused(2, {"measure", "phantom:ball:16", "--plot", "a.png"}, ".svg");
}

TEST(MeasureCommand, ABallIsMeasured) {
  const double r = kBallRadius, pi = std::numbers::pi;
  const json ball = jsonOf({"measure", "phantom:ball:64", "--json", "--distance", "-22,0,0 0,22,0", "--angle",
                            "1,0,0 0,0,0 0,1,0", "--angle", "1,0,0 0,0,0 0,1,0 0,1,5", "--circle",
                            "3,0,0 0,0,0 0,4,0", "--thickness", "0,0,22"});
  expectWithinError(ball["area_mm2"], 4.0 * pi * r * r);
  expectWithinError(ball["volume_mm3"], 4.0 / 3.0 * pi * r * r * r);
  EXPECT_FALSE(ball["open"].get<bool>());
  EXPECT_NEAR(ball["volume_per_value_mm3"].get<double>(), 4.0 * pi * r * r, 10.0);
  EXPECT_NEAR(ball["distances"][0]["straight_mm"]["value"].get<double>(), 22.0 * std::sqrt(2.0), 1e-9);
  expectWithinError(ball["distances"][0]["along_surface_mm"], 0.5 * pi * r);
  EXPECT_GT(ball["distances"][0]["path_mm"].size(), 100u);
  EXPECT_NEAR(ball["angles"][0]["degrees"]["value"].get<double>(), 90.0, 1e-9);
  EXPECT_NEAR(ball["angles"][1]["degrees"]["value"].get<double>(), 90.0, 1e-9);
  EXPECT_NEAR(ball["circles"][0]["radius_mm"]["value"].get<double>(), 2.5, 1e-9);
  expectWithinError(ball["thicknesses"][0]["ray_mm"], 2.0 * r);
  expectWithinError(ball["thicknesses"][0]["ball_mm"], 2.0 * r);
}

TEST(MeasureCommand, ABoxOfIt) {
  const json half = jsonOf({"measure", "phantom:ball:64", "--json", "--box", "0,-40,-40 40,40,40"});
  expectWithinError(half["volume_mm3"], 2.0 / 3.0 * std::numbers::pi * std::pow(kBallRadius, 3));
  const json nothing = jsonOf({"measure", "phantom:ball:64", "--json", "--box", "30,30,30 31,31,31"});
  EXPECT_EQ(nothing["area_mm2"]["value"].get<double>(), 0.0);
}

TEST(MeasureCommand, AsText) {
  const RunResult result =
      callIsolux({"measure", "phantom:ball:32", "--thickness", "0,0,10.8"}, temporaryFolder());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("area          "));
  EXPECT_THAT(result.out, HasSubstr("  by ball     "));
}

TEST(MeasureCommand, OpenSurfacesAreMarkedOrRefused) {
  const RunResult open = callIsolux({"measure", "phantom:cylinder:16", "--json"}, temporaryFolder());
  EXPECT_TRUE(json::parse(open.out)["open"].get<bool>());
  EXPECT_THAT(open.err, HasSubstr("the surface is open"));
  expectRefused(3, {"measure", "phantom:cylinder:16", "--closed"}, "the surface is open");
}

TEST(MeasureCommand, WhatCannotBeMeasuredIsOneLine) {
  expectRefused(3, {"measure", "phantom:ball:16", "--isovalue", "1000"}, "no surface; the data range is");
  expectRefused(3, {"measure", "phantom:ball:16", "--thickness", "100,0,0"}, "no isosurface");
  expectRefused(2, {"measure", "phantom:ball:16", "--thickness", "1,2"}, "is not a position");
  expectRefused(2, {"measure", "phantom:ball:16", "--distance", "1,2,3"}, "2 positions");
  expectRefused(2, {"measure", "phantom:ball:16", "--distance", "1,2,nan 1,2,3"}, "is not a position");
  expectRefused(2, {"measure", "phantom:ball:16", "--circle", "0,0,0 1,1,1 2,2,2"}, "on a line");
  expectRefused(2, {"measure", "phantom:ball:16", "--box", "0,0,0 0,1,1"}, "is empty");
  expectRefused(2, {"measure"}, "PATH");
  const json apart = jsonOf({"measure", "phantom:ball:16", "--json", "--distance", "0,0,0 100,0,0"});
  EXPECT_TRUE(apart["distances"][0]["along_surface_mm"].is_null());
  EXPECT_THAT(apart["distances"][0]["along_surface_reason"].get<std::string>(), HasSubstr("no isosurface"));
}

TEST(MeasureCommand, DoubtfulLengthsAreRefused) {
  const fs::path folder = temporaryFolder();
  std::ofstream(folder / "a.mhd")
      << "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\n"
         "ElementDataFile = a.raw\n";
  std::string voxels(64, '\0');
  voxels[21] = voxels[22] = voxels[25] = voxels[26] = 100;
  std::ofstream(folder / "a.raw") << voxels;
  const std::vector<std::string> arguments{"measure", "a.mhd", "--isovalue", "50", "--json"};
  expectRefused(3, arguments, "ElementSpacing is missing", folder);
  std::vector<std::string> anyway = arguments;
  anyway.emplace_back("--anyway");
  EXPECT_THAT(jsonOf(anyway, folder)["doubt"].get<std::string>(), HasSubstr("ElementSpacing is missing"));
}

TEST(MeasureCommand, MarksOfAFileAndOfASession) {
  const fs::path folder = temporaryFolder();
  std::ofstream(folder / "m.mrk.json") << R"({"markups": [
      {"type": "Line", "name": "across", "coordinateSystem": "RAS",
       "controlPoints": [{"position": [22, 0, 0]}, {"position": [0, -22, 0]}]},
      {"type": "Plane", "controlPoints": []}]})";
  const RunResult result =
      callIsolux({"measure", "phantom:ball:64", "--json", "--marks", "m.mrk.json", "--out", "m.csv"}, folder);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("Plane"));
  const json marks = json::parse(result.out)["marks"];
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0]["points_mm"][0][0].get<double>(), -22.0);
  EXPECT_NEAR(marks[0]["quantities"]["straight"]["value"].get<double>(), 22.0 * std::sqrt(2.0), 1e-9);
  EXPECT_THAT(contentOf(folder / "m.csv"), HasSubstr("across,distance,\"-22 0 0; 0 22 0\",straight,31.11"));
  const std::string session = R"(marks.list=[{"kind": "thickness", "name": "wall", "points": [[0, 0, 22]]}])";
  const RunResult text = callIsolux({"measure", "phantom:ball:64", "--set", session}, folder);
  EXPECT_THAT(text.out, HasSubstr("wall (thickness)\n  ray: 44."));
  expectRefused(2, {"measure", "phantom:ball:64", "--out", "x.csv"}, "no marks to write", folder);
  expectRefused(2, {"measure", "phantom:ball:64", "--marks", "m.mrk.json", "--out", "m.mrk.json"},
                "m.mrk.json", folder);
  std::ofstream(folder / "bad.mrk.json") << "{";
  expectRefused(3, {"measure", "phantom:ball:64", "--marks", "bad.mrk.json"}, "is not JSON", folder);
  expectRefused(3, {"measure", "phantom:ball:64", "--marks", "none.mrk.json"}, "none.mrk.json", folder);
}

TEST(ProbeCommand, PointsAndRaysOfABall) {
  const fs::path folder = temporaryFolder();
  std::ofstream(folder / "points.csv") << "x,y,z\n10,0,0\n# a remark\n0;5.5;7\n500,0,0\n";
  std::ofstream(folder / "rays.csv") << "0,0,100,0,0,-2\n0,0,100,0,0,1\n";
  const json points = jsonOf({"probe", "phantom:ball:64", "--points", "points.csv", "--json"}, folder);
  ASSERT_EQ(points.size(), 3u);
  const json& first = points[0];
  EXPECT_NEAR(first["value"].get<double>(), kBallRadius - 10.0, 0.03);
  EXPECT_NEAR(first["normal"][0].get<double>(), 1.0, 1e-3);
  EXPECT_NEAR(first["gradient"][0].get<double>(), -1.0, 0.01);
  EXPECT_NEAR(first["kappa"][0].get<double>(), 0.1, 0.003);
  EXPECT_EQ(first["voxel"][0].get<double>(), 41.5);
  EXPECT_TRUE(first["edge_offset_mm"].is_null());
  EXPECT_TRUE(points[2]["value"].is_null());
  const json rays = jsonOf({"probe", "phantom:ball:64", "--rays", "rays.csv", "--json"}, folder);
  const json& hit = rays[0]["hit"];
  EXPECT_LE(std::abs(hit["t_mm"].get<double>() - (100.0 - kBallRadius)), hit["t_error_mm"].get<double>());
  EXPECT_TRUE(hit["entering"].get<bool>());
  EXPECT_TRUE(rays[1]["hit"].is_null());
  const json both =
      jsonOf({"probe", "phantom:ball:64", "--points", "points.csv", "--rays", "rays.csv", "--json"}, folder);
  EXPECT_EQ(both["points"].size(), 3u);
  EXPECT_EQ(both["rays"].size(), 2u);
}

TEST(ProbeCommand, ATableHasAsManyColumnsInEachRow) {
  const fs::path folder = temporaryFolder();
  std::ofstream(folder / "rays.csv") << "0,0,100,0,0,1\n0,0,100,0,0,-2\n";
  const RunResult result = callIsolux({"probe", "phantom:ball:32", "--rays", "rays.csv"}, folder);
  EXPECT_THAT(result.err, HasSubstr("1 of 2 rays hit nothing, the first in line 1"));
  std::istringstream lines(result.out);
  std::vector<std::ptrdiff_t> commas;
  for (std::string line; std::getline(lines, line);)
    commas.push_back(std::count(line.begin(), line.end(), ','));
  ASSERT_EQ(commas.size(), 3u);
  EXPECT_EQ(commas[0], commas[1]);
  EXPECT_EQ(commas[0], commas[2]);
}

TEST(ProbeCommand, NoFirstPointIsTakenForNames) {
  const fs::path folder = temporaryFolder();
  const auto rows = [&](const std::string& text) {
    std::ofstream(folder / "p.csv") << text;
    return jsonOf({"probe", "phantom:ball:16", "--points", "p.csv", "--json"}, folder).size();
  };
  EXPECT_EQ(rows("\xef\xbb\xbf"
                 "1,2,3\n4,5,6\n"),
            2u)
      << "a byte order mark";
  EXPECT_EQ(rows("\xef\xbb\xbf"
                 "x,y,z\r\n4,5,6\r\n"),
            1u);
  EXPECT_EQ(rows("\"1\",\"2\",\"3\"\n4,5,6\n"), 2u);
  EXPECT_EQ(rows("\"x, mm\",\"y\",\"info\"\n4,5,6\n"), 1u);
  for (const char* first :
       {"1,2,3mm", "nan,2,3", "1mm,2mm,3mm", "a,b,3", "inf,nan,nan", "1e999,x,y", "1,2"}) {
    std::ofstream(folder / "p.csv") << first << "\n4,5,6\n";
    expectRefused(3, {"probe", "phantom:ball:16", "--points", "p.csv"}, "line 1", folder);
  }
}

TEST(ProbeCommand, BadRowsAreOneLine) {
  const fs::path folder = temporaryFolder();
  std::ofstream(folder / "bad.csv") << "1,2,3\n1,2\n";
  std::ofstream(folder / "words.csv") << "1,2,3\n1,2,three\n";
  std::ofstream(folder / "empty.csv") << "x,y,z\n";
  std::ofstream(folder / "still.csv") << "1,2,3,0,0,0\n";
  expectRefused(3, {"probe", "phantom:ball:8", "--points", "bad.csv"}, "line 2", folder);
  expectRefused(3, {"probe", "phantom:ball:8", "--points", "words.csv"}, "line 2", folder);
  expectRefused(3, {"probe", "phantom:ball:8", "--points", "empty.csv"}, "no rows", folder);
  expectRefused(3, {"probe", "phantom:ball:8", "--points", "missing.csv"}, "missing.csv", folder);
  expectRefused(3, {"probe", "phantom:ball:8", "--rays", "still.csv"}, "needs a direction", folder);
  expectRefused(2, {"probe", "phantom:ball:8"}, "--points", folder);
}

}  // namespace
}  // namespace isolux::test
