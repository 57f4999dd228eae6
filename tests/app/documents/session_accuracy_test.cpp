// The accuracy in a picture's session: carried, and read past.
#include "app/documents/session_accuracy.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/documents/session.h"

namespace isolux::app {
namespace {

TEST(SessionAccuracy, IsCarriedAndIsNoSetting) {
  scene::Scene scene;
  scene.camera.fov = 33.0;
  Accuracy accuracy;
  accuracy.pixels = 7;
  accuracy.depthMm = {0.25, std::numeric_limits<double>::quiet_NaN()};
  const std::string plain = sessionText(scene, "/");
  const std::string carries = sessionWithAccuracy(plain, accuracy);
  nlohmann::json json = nlohmann::json::parse(carries);
  EXPECT_EQ(json["accuracy"]["pixels"], 7);
  EXPECT_EQ(json["accuracy"]["depth_mm"]["median"], 0.25);
  EXPECT_TRUE(json["accuracy"]["depth_mm"]["most_99"].is_null());
  EXPECT_TRUE(parseSession(carries, "", {"/"}) == scene);
  json.erase("accuracy");
  EXPECT_EQ(json, nlohmann::json::parse(plain)) << "nothing else of it changes";
}

TEST(SessionAccuracy, NoSessionStaysNone) {
  EXPECT_EQ(sessionWithAccuracy("", {}), "");
}

}  // namespace
}  // namespace isolux::app
