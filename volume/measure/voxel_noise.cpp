#include "volume/measure/voxel_noise.h"

#include "volume/read/input/spacing_reliability.h"

namespace isolux::volume {

scene::NoiseModel voxelNoise(const PreparedVolume& volume, const scene::Scene& scene,
                             base::Progress& progress) {
  scene::NoiseModel noise = volume.derivativeChoices->noise(progress);
  if (scene.derivatives.noise) {
    noise.values = {0.0};
    noise.deviations = {*scene.derivatives.noise};
  }
  noise.slicesMm = widestSlicesMm(volume.volume.warnings).value_or(0.0);
  return noise;
}

}  // namespace isolux::volume
