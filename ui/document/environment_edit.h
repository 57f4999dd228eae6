// Edits of the environment that several places make: turning it, and choosing one.
#pragma once

#include <glm/vec4.hpp>

#include "scene/world_axes.h"
#include "ui/document/edit.h"

namespace isolux::ui {

// Why turning the environment would do nothing; empty: it turns.
QString whyItCannotTurn(const scene::Scene& scene);

// Parts of one gesture. With gi.mode auto an environment that is turned is one that moves: from then on light
// is stored so that turning costs nothing.
Edit environmentTurned(const scene::Scene& scene, const glm::dvec4& rotation,
                       scene::WorldAxes axes);                        // to it
Edit environmentTurnedBy(const scene::Scene& scene, double degrees);  // of azimuth
Edit lettingMove(Edit turned);  // an edit of azimuth or elevation made elsewhere
// Whether `edit`, made of `before`, was what first let the environment move.
bool letsEnvironmentMove(const scene::Scene& before, const Edit& edit);

// Image files that can be light probes: of what is dropped on the window.
bool isLightProbe(const QString& file);
// Takes the file as light probe, or the built-in light, and the look that it lights where none does yet.
Edit lightProbeChosen(const scene::Scene& scene, const QString& file);
Edit builtInLightChosen(const scene::Scene& scene, scene::BuiltInLight light);

}  // namespace isolux::ui
