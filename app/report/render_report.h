// What `isolux render` says of a picture: --stats, --explain and notes.
#pragma once

#include "app/accuracy/accuracy.h"
#include "app/accuracy/hidden_structure.h"
#include "app/light/light_controller.h"
#include "app/report/derivative_report.h"
#include "render/gl/gl_context.h"
#include "render/still_picture.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct Drawn {
  render::StillPicture picture;  // the last one
  double milliseconds = 0.0;     // median of the measured pictures
  int repeat = 0;                // how many were
};

// docs/reference/outputs.md has the keys. `scene`: as it was drawn, but for the hits of pictures at rest.
// accuracy: none where nobody asked for it.
nlohmann::ordered_json renderJson(const scene::Scene& scene, const render::FrameRequest& request,
                                  const volume::PreparedVolume& prepared,
                                  const render::ContextDescription& context, const Drawn& drawn,
                                  const LightController& light, const DerivativeFacts& derivatives,
                                  const std::optional<Accuracy>& accuracy);

// Of a volume read at a coarser level; null at level 0. structure: none where the volume has no index.
nlohmann::ordered_json levelJson(int level, const volume::Grid& grid,
                                 const std::optional<HiddenStructure>& structure);

void printPasses(const render::FrameReport& report);
// Where bricks.lost > 0: how much of the picture that is, and why.
std::string lostLine(const render::BrickReport& bricks);
// Notes on stderr about a picture that has been written.
void noteOfPicture(const scene::Scene& scene, const render::FrameReport& report);

}  // namespace isolux::app
