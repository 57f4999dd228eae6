// Markups JSON of 3D Slicer, written and read, and tables of marks.
#include "app/marks/markups_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/marks/mark_kinds.h"
#include "app/marks/mark_report.h"
#include "base/error.h"

namespace isolux::test {
namespace {

using nlohmann::json;
using scene::Mark;
using scene::MarkKind;
using testing::HasSubstr;

std::vector<Mark> oneOfEachKind() {
  const glm::dvec3 a(0.1, -123.456789012345, 1e-7), b(1.0 / 3.0, 2.0, 3.0), c(-7.25, 0.0, 9.0), d(1, 1, 1);
  return {{MarkKind::point, "Pin \"1\", é", {a}},
          {MarkKind::distance, "D", {a, b}, {0.2, 0.4, 0.8}, false},
          {MarkKind::distance, "D3", {a, b, c}},
          {MarkKind::path, "P", {a, b, c}, {1.0, 0.0, 0.0}},
          {MarkKind::angle, "A", {a, b, c}},
          {MarkKind::angle, "A4", {a, b, c, d}},
          {MarkKind::circle, "C", {a, b, c}},
          {MarkKind::thickness, "T", {a}},
          {MarkKind::piece, "W", {b}}};
}

void expectSame(const std::vector<Mark>& read, const std::vector<Mark>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].kind, written[i].kind) << i;
    EXPECT_EQ(read[i].name, written[i].name);
    EXPECT_EQ(read[i].points, written[i].points) << i;  // to the last bit
    EXPECT_EQ(read[i].shown, written[i].shown);
    EXPECT_LT(glm::length(read[i].color - written[i].color), 1e-12);
  }
}

std::vector<Mark> marksOf(const std::string& text) {
  return app::parseMarkups(text, "f.mrk.json").marks;
}

std::string refusal(const std::string& text) {
  try {
    app::parseMarkups(text, "f.mrk.json");
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    return error.what();
  }
  return "accepted";
}

// As Slicer 5 writes a line, with what it has beside.
constexpr auto kSlicerLine = R"({
    "@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
    "markups": [{
        "type": "Line", "coordinateSystem": "LPS", "coordinateUnits": "mm", "locked": false,
        "fixedNumberOfControlPoints": false, "labelFormat": "%N-%d", "lastUsedControlPointNumber": 2,
        "controlPoints": [
            {"id": "1", "label": "L-1", "description": "", "associatedNodeID": "vtkMRMLScalarVolumeNode1",
             "position": [-9.5, 1.25, 12.5], "orientation": [-1.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 1.0],
             "selected": true, "locked": false, "visibility": true, "positionStatus": "defined"},
            {"id": "2", "label": "L-2", "position": [4.0, 5.0, 6.0], "positionStatus": "defined"}],
        "measurements": [{"name": "length", "enabled": true, "value": 15.3, "units": "mm", "printFormat": "%-#4.4g%s"}],
        "display": {"visibility": true, "opacity": 1.0, "color": [0.4, 1.0, 1.0],
                    "selectedColor": [1.0, 0.5, 0.5], "activeColor": [0.4, 1.0, 0.0]}}]})";

TEST(MarkupsFile, WhatIsWrittenIsReadAgain) {
  const std::vector<Mark> marks = oneOfEachKind();
  expectSame(marksOf(app::markupsText(marks)), marks);
}

// What another program that knows only Slicer's types gets to see.
TEST(MarkupsFile, WithoutOurKeySlicersTypesSayAsMuchAsTheyCan) {
  const std::vector<Mark> marks = oneOfEachKind();
  json file = json::parse(app::markupsText(marks));
  const char* const types[] = {"Fiducial", "Line",     "Curve",    "Curve",   "Angle",
                               "Fiducial", "Fiducial", "Fiducial", "Fiducial"};
  ASSERT_EQ(file["markups"].size(), std::size(types));
  for (std::size_t i = 0; i < std::size(types); ++i) {
    EXPECT_EQ(file["markups"][i]["type"], types[i]);
    EXPECT_EQ(file["markups"][i]["coordinateSystem"], "LPS");
    file["markups"][i].erase("isolux");
  }
  const std::vector<Mark> read = marksOf(file.dump());
  const std::vector<Mark> expressible{marks[0], marks[1], marks[4]};
  expectSame({read[0], read[1], read[4]}, expressible);
  EXPECT_EQ(read[2].kind, MarkKind::path);
  EXPECT_EQ(read[3].points, marks[3].points);
  EXPECT_EQ(read.size(), 5u + 4u + 3u + 1u + 1u);  // lists of points are pins
}

TEST(MarkupsFile, ALineOfSlicer) {
  const std::vector<Mark> marks = marksOf(kSlicerLine);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].kind, MarkKind::distance);
  EXPECT_EQ(marks[0].name, "Distance 1");
  EXPECT_EQ(marks[0].points, (std::vector<glm::dvec3>{{-9.5, 1.25, 12.5}, {4, 5, 6}}));
  EXPECT_NEAR(marks[0].color.x, 1.0, 1e-12);
  EXPECT_NEAR(marks[0].color.y, std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-12);
}

TEST(MarkupsFile, SystemsAndUnits) {
  const auto positionIn = [](const std::string& keys) {
    return marksOf(R"({"markups": [{"type": "Fiducial", )" + keys +
                   R"("controlPoints": [{"label": "F", "position": [1, 2, 3]}]}]})")[0]
        .points[0];
  };
  EXPECT_EQ(positionIn(""), glm::dvec3(1, 2, 3));
  EXPECT_EQ(positionIn(R"("coordinateSystem": "RAS", )"), glm::dvec3(-1, -2, 3));
  EXPECT_EQ(positionIn(R"("coordinateSystem": 0, )"), glm::dvec3(-1, -2, 3));
  EXPECT_EQ(positionIn(R"("coordinateSystem": "1", )"), glm::dvec3(1, 2, 3));
  EXPECT_EQ(positionIn(R"("coordinateUnits": ["mm", "UCUM", "millimeter"], )"), glm::dvec3(1, 2, 3));
  EXPECT_LT(glm::length(positionIn(R"("coordinateUnits": "um", )") - glm::dvec3(0.001, 0.002, 0.003)), 1e-15);
}

TEST(MarkupsFile, WhatIsNoMarkIsNoted) {
  const app::ReadMarks read = app::parseMarkups(R"({"markups": [
      {"type": "ROI", "center": [0, 0, 0]},
      {"type": "Fiducial", "controlPoints": [{"position": [0, 0, 0], "positionStatus": "undefined"},
                                              {"position": [1, 1, 1], "visibility": false}]},
      {"type": "ClosedCurve", "controlPoints": [{"position": [0, 0, 0]}, {"position": [1, 0, 0]}]}]})",
                                                "f");
  ASSERT_EQ(read.marks.size(), 2u);
  EXPECT_EQ(read.marks[0].name, "Pin 1");
  EXPECT_FALSE(read.marks[0].shown);
  EXPECT_EQ(read.marks[1].points.front(), read.marks[1].points.back());
  ASSERT_EQ(read.notes.size(), 2u);
  EXPECT_THAT(read.notes[0], HasSubstr("ROI"));
  EXPECT_THAT(read.notes[1], HasSubstr("1 points are not set"));
}

TEST(MarkupsFile, WrongFilesAreRefusedWithThePlace) {
  EXPECT_THAT(refusal("not json"), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal(R"({"markups": [{"type": "Line", "controlPoints": [{"position": [1e999, 0, 0]}]}]})"),
              HasSubstr("is not JSON"));
  EXPECT_THAT(refusal("{}"), HasSubstr("no list \"markups\""));
  EXPECT_THAT(refusal("[1]"), HasSubstr("no list \"markups\""));
  EXPECT_THAT(refusal(R"({"markups": [1]})"), HasSubstr("markups[0]"));
  EXPECT_THAT(refusal(R"({"markups": [{}]})"), HasSubstr("has no type"));
  EXPECT_THAT(refusal(R"({"markups": [{"type": 7}]})"), HasSubstr("is not a text"));
  EXPECT_THAT(refusal(R"({"markups": [{"type": "Line", "controlPoints": [{"position": [1, 2]}]}]})"),
              HasSubstr("markups[0].controlPoints[0].position"));
  EXPECT_THAT(refusal(R"({"markups": [{"type": "Line", "controlPoints": [{"position": [1, 2, "3"]}]}]})"),
              HasSubstr("is not [x, y, z]"));
  EXPECT_THAT(refusal(R"({"markups": [{"type": "Line", "controlPoints": [{"position": [1, 2, 3]}]}]})"),
              HasSubstr("two points or more"));
  EXPECT_THAT(
      refusal(R"({"markups": [{"type": "Fiducial", "coordinateSystem": "XYZ", "controlPoints": []}]})"),
      HasSubstr("neither LPS nor RAS"));
  EXPECT_THAT(
      refusal(R"({"markups": [{"type": "Fiducial", "coordinateUnits": "inch", "controlPoints": []}]})"),
      HasSubstr("neither mm nor um"));
  EXPECT_THAT(
      refusal(R"({"markups": [{"type": "Fiducial", "controlPoints": [{"position": [1e30, 0, 0]}]}]})"),
      HasSubstr("invalid value"));
}

// Names that are free were looked for before the marks were counted: minutes for 10 000.
TEST(MarkupsFile, TooManyMarksAreRefusedAtOnce) {
  json point{{"position", {0, 0, 0}}};
  json file{{"markups", {{{"type", "Fiducial"}, {"controlPoints", json::array()}}}}};
  for (int i = 0; i < 100000; ++i) file["markups"][0]["controlPoints"].push_back(point);
  EXPECT_THAT(refusal(file.dump()), HasSubstr("at most 1024 marks"));
}

TEST(MarkReports, ATableHasARowForEachQuantity) {
  const std::vector<Mark> marks{{MarkKind::distance, "a, \"b\"", {{0, 0, 0}, {1, 2, 3}}},
                                {MarkKind::circle, "c", {{0, 0, 0}}}};
  std::vector<app::MarkReport> reports(2);
  reports[0].quantities = {{"straight", 3.5, 0.25, "mm"}, {"straight_1_2", 3.5, {}, "mm"}};
  reports[0].notes = {"far, off"};
  reports[1].problem = "the points are on a line";
  EXPECT_EQ(app::marksCsv(marks, reports),
            "mark,kind,points_mm,quantity,value,error,unit,notes\n"
            "\"a, \"\"b\"\"\",distance,\"0 0 0; 1 2 3\",straight,3.5,0.25,mm,\"far, off\"\n"
            "\"a, \"\"b\"\"\",distance,\"0 0 0; 1 2 3\",straight_1_2,3.5,,mm,\"far, off\"\n"
            "c,circle,0 0 0,,,,,the points are on a line\n");
}

TEST(MarkReports, ATableRunsNothingInASpreadsheetAndMovesNoCursor) {
  const auto fieldOf = [](const std::string& name) {
    const std::string table = app::marksCsv(std::vector<Mark>{{MarkKind::point, name, {{-1, 0, 0}}}},
                                            std::vector<app::MarkReport>(1));
    const std::size_t begin = table.find('\n') + 1;
    return table.substr(begin, table.find(",point,-1 0 0,", begin) - begin);
  };
  EXPECT_EQ(fieldOf("=1+1"), "'=1+1");
  EXPECT_EQ(fieldOf("@SUM(A1,2)"), "\"'@SUM(A1,2)\"");
  EXPECT_EQ(fieldOf("-2"), "'-2");
  EXPECT_EQ(fieldOf("two\nlines\x1b[2J"), "two?lines?[2J");
  EXPECT_EQ(fieldOf("a=b"), "a=b");
}

TEST(MarkReports, NumbersHaveTheDigitsOfTheirError) {
  EXPECT_EQ(app::quantityText({"q", 92.31456, 0.0234, "mm"}), "92.315 ± 0.023 mm");
  EXPECT_EQ(app::quantityText({"q", 44860.9, 170.0, "mm³"}), "44861 ± 170 mm³");
  EXPECT_EQ(app::quantityText({"q", 0.5, {}, ""}), "0.5");
  EXPECT_EQ(app::quantityText({"q", 5.0, 0.0, "mm"}), "5 mm");
  EXPECT_EQ(app::quantityText({"q", 90.0, 1.5, "°"}), "90.0 ± 1.5°");
}

TEST(MarkKinds, NewNamesAreFree) {
  const std::vector<Mark> marks{{MarkKind::point, "Pin 1", {}}, {MarkKind::point, "Pin 3", {}}};
  EXPECT_EQ(app::freshName(MarkKind::point, marks), "Pin 2");
  EXPECT_EQ(app::freshName(MarkKind::distance, marks), "Distance 1");
}

}  // namespace
}  // namespace isolux::test
