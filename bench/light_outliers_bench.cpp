// Outliers of stored light with few paths: RMSE, 99.9 % quantile and largest error of a view's pixels against
// path tracing under Grace Cathedral, at 16 and 100 paths a texel, and at 1024, where place is what is left:
// what errs as much there is no chance.
#include <cstdio>

#include "app/study/study.h"
#include "bench/bench.h"
#include "bench/subjects.h"
#include "render/gl/gl_context.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

constexpr glm::ivec2 kPictureSize(256);
constexpr int kPathsTried[] = {16, 100, 1024};

struct Judged {
  const char* name;
  std::string path;
  double isovalue;  // data units
};

// Of the default of gi.texels.
app::LightErrors errorsOf(const std::shared_ptr<const render::Gl>& gl, const VolumePointer& volume,
                          scene::Scene scene, int paths) {
  scene.gi.samples = paths;
  app::QualitySetting quality = app::parseQualitySettings("texels").front();
  quality.cost = app::Cost::lookupMilliseconds;
  base::Progress progress;
  const app::QualityStudy study =
      app::StudyRunner(gl, {volume, scene, {.executor = scene::Executor::cpu}, kPictureSize, 1})
          .study(quality, progress, 0.0, 1.0);
  for (const app::StudySetting& setting : study.settings)
    if (setting.isDefault) return setting.errors.light;
  throw std::logic_error("gi.texels has no default");
}

void judge(const Judged& judged) {
  const VolumePointer volume = load(judged.path);
  const auto context = render::OffscreenContext::create({});
  scene::Scene scene;
  scene.surfaces.front().value = judged.isovalue;
  scene.light.environment.file = (test::dataFolder() / "hdr/grace_cathedral_1k.hdr").string();
  std::printf("  %-26s", judged.name);
  for (const int paths : kPathsTried) {
    const app::LightErrors e = errorsOf(context->gl(), volume, scene, paths);
    const auto percent = [&](double error) { return 100.0 * e.relative(error); };
    std::printf(" | %5.2f ±%.2f %6.1f %+7.1f at %5zu", percent(e.rmse), percent(e.rmseStandardError),
                percent(e.most999), percent(e.maximum), e.maximumPixel);
    std::fflush(stdout);
  }
  std::printf("\n");
}

void run() {
  const std::filesystem::path data = test::dataFolder() / "volumes";
  if (test::dataFolder().empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  std::printf(
      "  in %% of the mean irradiance: RMSE, 99.9 %% quantile, largest error and its pixel; at 16, 100 and "
      "1024 paths\n");
  for (const Judged& judged :
       {Judged{"head phantom", "phantom:head", 300.0}, Judged{"engine_crop", data / "engine_crop.mhd", 80.0},
        Judged{"ct_head_skin_bone, bone", data / "ct_head_skin_bone.nii.gz", 0.51},
        Judged{"ct_head_pitch, 200", data / "ct_head_pitch.nii.gz", 200.0},
        Judged{"mri_colin27", data / "mri_colin27.nii.gz", 71.5}})
    judge(judged);
}

const Registration registration("light_outliers", "outliers of stored light at 16, 100 and 1024 paths", run);

}  // namespace
}  // namespace isolux::bench
