#include "volume/measure/voxel_noise.h"

namespace isolux::volume {

scene::NoiseModel voxelNoise(const PreparedVolume& volume, const scene::Scene& scene,
                             base::Progress& progress) {
  scene::NoiseModel noise = volume.derivativeChoices->noise(progress);
  if (scene.derivatives.noise) {
    noise.values = {0.0};
    noise.deviations = {*scene.derivatives.noise};
  }
  return noise;
}

}  // namespace isolux::volume
