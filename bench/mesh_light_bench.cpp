// Our light tracer against an independent path tracer of the isosurface's mesh (mesh_path_tracer.h) at the
// same points: the mean's difference, and how far pixels differ beyond the noise of both.
#include <cmath>
#include <cstdio>

#include "app/study/light_reference.h"
#include "bench/bench.h"
#include "bench/mesh_path_tracer.h"
#include "bench/subjects.h"
#include "gi/trace/primary_hits.h"
#include "tests/support/test_data.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::bench {
namespace {

constexpr std::size_t kPoints = 512;
constexpr int kPaths = 16384;  // of the mesh's tracer, a point

void compare(const Subject& subject, const std::string& probe) {
  base::Progress progress;
  scene::Scene wanted;
  wanted.look.mode = scene::LookMode::gi;
  wanted.surfaces.front().value = subject.isovalue;
  wanted.light.environment.file = probe;
  wanted.gi.bounces = 1;
  const scene::Scene scene = scene::resolve(wanted, subject.volume->facts);
  const std::shared_ptr<const volume::Grid> grid(subject.volume, &subject.volume->grid());
  const auto light =
      gi::makeLightScene(scene, subject.volume,
                         std::make_shared<volume::IsosurfaceTracer>(grid, scene.isosurface.inside, progress),
                         gi::loadEnvironment(scene.light.environment));

  const gi::PrimaryHits hits(subject.volume, scene, glm::ivec2(64), progress);
  std::vector<glm::vec3> voxels;
  std::vector<bool> outer;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) {
      const auto hit = hits.at({column, row});
      outer.push_back(hit && hit->outer);
      voxels.emplace_back(hit ? hit->voxel : glm::dvec3(0.0));
    }
  const std::vector<std::size_t> pixels = app::chosenPixels(outer, kPoints);
  std::vector<glm::vec3> points;
  for (const std::size_t pixel : pixels) points.push_back(voxels[pixel]);
  const app::LightReference ours =
      app::lightReferenceAt(light, glm::dvec3(1.0), grid->storedIsovalue(subject.isovalue), points, pixels,
                            {.relativeNoise = 0.002}, progress);

  const MeshPathTracer mesh(light, trianglesOf(*grid, subject.isovalue), subject.isovalue);
  std::vector<MeshPathTracer::Estimate> theirs(points.size());
  volume::parallelEach(points.size(),
                       [&](std::size_t i) { theirs[i] = mesh.irradiance(points[i], i, kPaths); });

  // lightReferenceAt leaves out points without a normal.
  double mean = 0.0, difference = 0.0, noise = 0.0, square = 0.0, count = 0.0;
  for (std::size_t i = 0, j = 0; i < ours.pixels.size(); ++i) {
    while (pixels[j] != ours.pixels[i]) ++j;
    for (int c = 0; c < 3; ++c) {
      const double d = theirs[j].irradiance[c] - ours.irradiance[i][c];
      mean += ours.irradiance[i][c];
      difference += d;
      square += d * d;
      noise += ours.variance[i][c] + theirs[j].variance[c];
      count += 1.0;
    }
  }
  mean /= count;
  const double beyond = std::max(0.0, square - noise) / count;
  // Channels of a pixel share their paths, so that there are a third as many independent differences.
  std::printf(
      "  %-26s %4.0f points: mean off by %+6.3f %% ± %.3f, pixels by %5.2f %% beyond the noise of %.2f %%\n",
      subject.name.c_str(), count / 3.0, 100.0 * difference / count / mean,
      100.0 * std::sqrt(square / count / (count / 3.0)) / mean, 100.0 * std::sqrt(beyond) / mean,
      100.0 * std::sqrt(noise / count) / mean);
  std::fflush(stdout);
}

void run() {
  const std::filesystem::path data = test::dataFolder();
  if (data.empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  const std::string probe = (data / "hdr/grace_cathedral_1k.hdr").string();
  const std::string volumes = (data / "volumes").string();
  std::printf("  Embree on the mesh of flying edges, %d paths a point, one bounce, Grace Cathedral\n",
              kPaths);
  for (const Subject& subject :
       {Subject{"engine_crop", load(volumes + "/engine_crop.mhd"), 80.0},
        Subject{"ct_head_skin_bone, bone", load(volumes + "/ct_head_skin_bone.nii.gz"), 0.51},
        Subject{"heptane", load(volumes + "/heptane.nii.gz"), 60.0},
        Subject{"head phantom", load("phantom:head"), 300.0},
        Subject{"parallel sheets", load("phantom:sheets"), 0.0}})
    compare(subject, probe);
}

const Registration registration("mesh_light",
                                "the light tracer against an independent path tracer of the mesh", run);

}  // namespace
}  // namespace isolux::bench
