// What commands say of derivatives: noise, scales and why, what colours and lines take from the surface, and
// how much of it has a curvature that means something.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/picture/finished_picture.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct DerivativeFacts {
  scene::Derivatives asked;  // what of it is empty was automatic
  scene::Scene drawn;        // complete
  std::optional<volume::DerivativeChoice> choice;
  std::optional<render::CurvatureReport> curvature;
  // Of the surface points of the picture, those whose curvature_confidence is below 0.5; none: the picture
  // reads no curvature.
  std::optional<double> unknownShare;
};

// Of the last picture of `renderer`. Draws again what it has to read of it.
DerivativeFacts derivativeFacts(render::Renderer& renderer, const scene::Derivatives& asked,
                                const FinishedPicture& picture);

nlohmann::ordered_json choiceJson(const volume::DerivativeChoice& choice);
nlohmann::ordered_json derivativesJson(const DerivativeFacts& facts);
void printDerivatives(const DerivativeFacts& facts);

// Which field the hits of a picture of the scene at rest are of, and why (app/ready/rest_scene.h).
nlohmann::ordered_json restJson(const scene::Scene& drawn, const volume::PreparedVolume& volume);
void printRest(const scene::Scene& drawn, const volume::PreparedVolume& volume);

}  // namespace isolux::app
