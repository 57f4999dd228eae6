// A finished picture, as commands and Python draw it: with its fields, its light and hits at rest, and, where
// they are asked for, bounds of its errors.
#pragma once

#include <memory>
#include <optional>

#include "app/accuracy/accuracy.h"
#include "app/light/light_controller.h"
#include "render/still_picture.h"

namespace isolux::app {

struct PictureInputs {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // resolved; drawPicture() completes it
  render::FrameRequest request;
  int repeat = 0;       // frames to measure after one to warm up, in which every pass runs again
  bool errors = false;  // bounds of errors are asked for
  bool legend = true;   // false: nor where the scene has it
};

struct FinishedPicture {
  PictureInputs inputs;
  scene::Scene shown{};  // the scene as it was drawn, hits included
  render::StillPicture still{};
  double milliseconds = 0.0;  // the median of the measured frames
  std::optional<PictureErrors> errors{};
  std::optional<Accuracy> accuracy{};
};

// Draws with the volume and the machine of `renderer`. `light` bakes what is missing of the picture's light.
// Throws as completeFields(), lightPicture(), render::drawStill() and measureErrors().
FinishedPicture drawPicture(render::Renderer& renderer, LightController& light, PictureInputs inputs,
                            base::Progress& progress);

}  // namespace isolux::app
