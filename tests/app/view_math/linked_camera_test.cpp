#include "app/view_math/linked_camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace isolux::app {
namespace {

scene::VolumeFacts boxAt(glm::dvec3 middle, double half, scene::WorldAxes axes) {
  scene::VolumeFacts facts;
  facts.boundsMinMm = middle - glm::dvec3(half);
  facts.boundsMaxMm = middle + glm::dvec3(half);
  facts.axes = axes;
  return facts;
}

scene::Camera cameraAt(glm::dvec3 eye, glm::dvec3 target) {
  scene::Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.up = glm::dvec3(0, 0, 1);
  camera.fov = 25.0;
  return camera;
}

constexpr auto patient = scene::WorldAxes::anatomical;
constexpr auto object = scene::WorldAxes::zUp;

TEST(LinkedCamera, OfOnePatientIsTheSameInMillimetres) {
  const auto camera = cameraAt({10, -400, 30}, {10, 0, 30});
  EXPECT_EQ(linkedCamera(camera, boxAt({0, 0, 0}, 100, patient), boxAt({20, 10, -5}, 80, patient)), camera);
}

TEST(LinkedCamera, OfPatientsElsewhereKeepsDirectionAndScale) {
  const auto camera = cameraAt({10, -400, 30}, {10, 0, 30});
  const auto moved = linkedCamera(camera, boxAt({0, 0, 0}, 100, patient), boxAt({0, 0, 900}, 50, patient));
  EXPECT_EQ(*moved.eye, glm::dvec3(10, -400, 930));
  EXPECT_EQ(*moved.target, glm::dvec3(10, 0, 930));
  EXPECT_EQ(moved.fov, 25.0);
}

TEST(LinkedCamera, OfObjectsFillsThePictureAlike) {
  const auto camera = cameraAt({10, -400, 30}, {10, 0, 30});
  const auto first = boxAt({0, 0, 0}, 100, object), second = boxAt({5, 5, 5}, 10, object);
  const auto moved = linkedCamera(camera, first, second);
  // A tenth of the size: everything a tenth as far from the middle.
  EXPECT_NEAR(glm::length(*moved.eye - glm::dvec3(6, -35, 8)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(*moved.target - glm::dvec3(6, 5, 8)), 0.0, 1e-12);
  // And back.
  const auto back = linkedCamera(moved, second, first);
  EXPECT_NEAR(glm::length(*back.eye - *camera.eye), 0.0, 1e-9);
}

TEST(LinkedCamera, WithoutACameraNothingIsMade) {
  EXPECT_EQ(linkedCamera({}, boxAt({0, 0, 0}, 1, object), boxAt({9, 9, 9}, 2, object)), scene::Camera{});
}

}  // namespace
}  // namespace isolux::app
