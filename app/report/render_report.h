// Reports on a picture of `isolux render`: --stats, --explain and notes.
#pragma once

#include <string>
#include <vector>

#include "app/accuracy/hidden_structure.h"
#include "app/report/derivative_report.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

// docs/reference/outputs.md has the keys.
nlohmann::ordered_json renderJson(const FinishedPicture& picture, const render::ContextDescription& context,
                                  const LightController& light, const DerivativeFacts& derivatives);

// Describes a volume read at a coarser level; null at level 0. structure: none where the volume has no index.
nlohmann::ordered_json levelJson(int level, const volume::Grid& grid,
                                 const std::optional<HiddenStructure>& structure);

void printPasses(const render::FrameReport& report);
// Where bricks.lost > 0: how much of the picture that is, and why.
std::string lostLine(const render::BrickReport& bricks);
// What a note says of a picture: it is empty, parts of it are missing, the driver complains.
std::vector<std::string> notesOf(const render::FrameReport& report);
// Notes on stderr about a picture that has been written.
void noteOfPicture(const scene::Scene& scene, const render::FrameReport& report);

}  // namespace isolux::app
