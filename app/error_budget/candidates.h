// The combinations of settings that a search may take, made from the scene as it was given.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/error_budget/choice.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct TargetQuestion {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene given;            // as the user gave it, with the picture's camera; not resolved
  render::FrameRequest picture;  // size and deferred images
  scene::HostSettings host;
  bool processor = false;          // is the executor
  std::vector<std::string> fixed;  // paths of settings that stay as they are
};

// What decides which combinations there are.
struct Turning {
  scene::Scene given;                // as the user gave it
  scene::Field drawnField{};         // of its hits, at rest
  bool processor = false;            // it computes what it can
  bool derivatives = false;          // the picture reads gradients
  bool second = false;               // the picture reads second derivatives
  bool turnDerivatives = false;      // their fields are turned, too
  std::vector<std::string> fixed{};  // paths of settings that stay as they are
};

// Of hits and derivatives. The first is the most exact one; the others by work. Sampled hits of 40
// combinations of rate, near factor and refinement, of the drawn field; exact hits of it, and of the
// trilinear field where it is a spline; derivatives of the scene's field or the trilinear one.
std::vector<Candidate> surfaceCandidates(const Turning& turning);
// Paths per texel and texels per voxel, by work; their assignments come behind those of `surface`.
std::vector<Candidate> lightCandidates(const Turning& turning, const Candidate& surface);

// The scene as given, with a candidate's changes.
scene::Scene applied(const Candidate& candidate, scene::Scene given);

}  // namespace isolux::app
