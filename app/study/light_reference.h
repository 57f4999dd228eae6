// Irradiance at surface points by path tracing, as sure as asked for: the yardstick of the quality settings
// of light.
//
// Every point is estimated kReplicates times independently, with patterns of directions of its own
// (randomised quasi-Monte Carlo): the mean is the estimate, their spread its variance, unbiased also for
// well distributed directions. Owen 1998; Pharr et al., Physically Based Rendering, 4th ed., sec. 8.2.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/study/light_errors.h"
#include "app/study/study_errors.h"
#include "base/progress.h"
#include "gi/light_scene.h"

namespace isolux::app {

inline constexpr std::uint32_t kReplicates = 16;

struct LightReferenceOptions {
  std::uint32_t firstSamples = 256;  // paths of a replicate, a power of two; doubled until
  std::uint32_t mostSamples = 4096;
  double relativeNoise = 0.006;  // RMS of the standard errors, in parts of the mean, is at most this
};

// E of the scene's light, with exposure, at points of its first isosurface. Voxel coordinates; those without
// a normal are left out of LightReference::pixels, which are `pixels[i]` of `voxels[i]`. The sky's light
// counts with `skyScale`. Spread over the threads by TBB; the same for any number of them. Throws
// Error{interrupted}.
LightReference lightReferenceAt(const std::shared_ptr<const gi::LightScene>& light, glm::dvec3 skyScale,
                                float isovalue, std::span<const glm::vec3> voxels,
                                std::span<const std::size_t> pixels, const LightReferenceOptions& options,
                                base::Progress& progress);

bool canBeJudged(const TrueHit& hit);  // by its light: the surface is seen there, and from outside
// The same at `count` of the hits that can be judged, for the scene's light as it stands still, whatever is
// stored of it.
LightReference lightReferenceOf(scene::Scene scene,
                                const std::shared_ptr<const volume::PreparedVolume>& volume,
                                const std::vector<TrueHit>& hits, std::size_t count,
                                const LightReferenceOptions& options, base::Progress& progress);

// At most `count` of `hits` hits (those for which hit(i)), evenly spread in their order, each part's one by
// chance with a fixed seed.
std::vector<std::size_t> chosenPixels(const std::vector<bool>& hit, std::size_t count);

}  // namespace isolux::app
