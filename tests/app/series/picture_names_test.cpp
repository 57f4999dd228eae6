#include "app/series/picture_names.h"

#include <gtest/gtest.h>

#include "app/series/sweep.h"
#include "base/error.h"
#include "scene/settings/settings.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

TEST(PictureNames, FieldsStandForWhatTellsPicturesApart) {
  const PictureOfSeries picture{"/scans/ct.head.nii.gz", 3, 17, "-250.5"};
  EXPECT_EQ(expandedName("{name}.png", picture), "ct.head.png");
  EXPECT_EQ(expandedName("a/{n}_{i}_{value}.png", picture), "a/3_00017_-250.5.png");
  EXPECT_EQ(expandedName("{name}{name}.png", {"phantom:torus:64", 1, 0, ""}), "torustorus.png");
  EXPECT_EQ(expandedName("{nme}{.png", picture), "{nme}{.png") << "no field: part of the name";
}

TEST(PictureNames, ASeriesIsNumberedWhereTheNameDoesNotSay) {
  EXPECT_EQ(completePattern("a.png", 1, true), "a_{i}.png");
  EXPECT_EQ(completePattern("a{value}.png", 1, true), "a{value}.png");
  EXPECT_EQ(completePattern("a.png", 2, false), "a.png");
  EXPECT_EQ(completePattern("turn", 1, true), "turn/frame_{i}.png");
  EXPECT_EQ(completePattern("turn", 2, true), "turn/{name}_{i}.png");
  EXPECT_EQ(completePattern("all", 2, false), "all/{name}.png");
  EXPECT_EQ(completePattern("-", 2, true), "-");
}

TEST(PictureNames, TwoPicturesForOneFileAreRefused) {
  EXPECT_NO_THROW(checkNamesDiffer({"a.png", "b.png"}, "--out"));
  try {
    checkNamesDiffer({"x/a.png", "b.png", "x/./a.png"}, "--out");
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("x/./a.png"), std::string::npos) << error.what();
  }
}

TEST(Sweep, ValuesAreEvenlySpacedWithBothEnds) {
  const Sweep sweep = parseSweep("isosurface.value=100:300:9");
  ASSERT_EQ(sweep.count, 9);
  for (int i = 0; i < 9; ++i) EXPECT_DOUBLE_EQ(sweep.value(i), 100.0 + 25.0 * i);
  EXPECT_EQ(parseSweep("look.fog=0:1:4").value(3), 1.0);
  EXPECT_EQ(parseSweep("look.fog=0:1:11").value(3), 0.3) << "without the last bits of a sum";
  EXPECT_EQ(parseSweep("look.fog=0.25:1:1").value(0), 0.25);
  EXPECT_EQ(parseSweep("camera.fov=60:20:3").value(1), 40.0);
  scene::Scene scene;
  parseSweep("gi.bounces=1:3:3").apply(scene, 2);
  EXPECT_EQ(scene.gi.bounces, 3);
}

TEST(Sweep, WhatCannotBeSweptIsRefusedInOneLine) {
  for (const char* text :
       {"", "isosurface.value", "isosurface.value=", "isosurface.value=1:2", "isosurface.value=1:2:0",
        "isosurface.value=1:2:2.5", "isosurface.value=1:2:3:4",
        "isosurface.value=1:2:3:", "isosurface.value=a:2:3", "isosurface.value=1:2:1000000",
        "isosurface.value=1:inf:3", "look.mode=1:2:3", "camera.eye=1:2:3", "no.such=1:2:3", "look.fog=0:7:3",
        "gi.bounces=1:2:3", "memory.gpu_budget_mb=100:200:3"}) {
    try {
      parseSweep(text);
      ADD_FAILURE() << text;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage) << text;
    }
  }
}

}  // namespace
}  // namespace isolux::app
