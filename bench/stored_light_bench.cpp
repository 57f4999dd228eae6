// How far stored light is from path tracing under a light probe (Grace Cathedral, 100 paths a texel, one
// bounce), and what its error is made of: texels lit on the isosurface that is shown, with hardly any noise
// (where they are: the error of place); texels on isosurfaces of their own (and of other isovalues); both
// with the noise of 100 paths. Drawn with hits of the graphics card and of the processor.
#include <cstdio>

#include "app/study/study.h"
#include "bench/bench.h"
#include "bench/subjects.h"
#include "render/gl/gl_context.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

constexpr int kNearlyNoNoise = 1024;  // paths
constexpr glm::ivec2 kSize(256), kSizeOfSplit(64);

struct Lit {
  const char* name;
  std::string path;
  double isovalue;  // data units
  double judged;    // RMSE in % of the mean that the project asks for
};

std::vector<Lit> litSubjects() {
  const std::filesystem::path data = test::dataFolder() / "volumes";
  const std::string ct = data / "ct_head_skin_bone.nii.gz";
  return {
      {"engine_crop", data / "engine_crop.mhd", 80.0, 3.0}, {"ct_head_skin_bone, skin", ct, 0.196, 3.0},
      {"ct_head_skin_bone, bone", ct, 0.51, 3.5},           {"heptane", data / "heptane.nii.gz", 60.0, 4.0},
      {"head phantom", "phantom:head", 300.0, 4.0},         {"parallel sheets", "phantom:sheets", 0.0, 4.0}};
}

// Where texels are lit; light of one bake is drawn for each value.
app::QualitySetting texelsQuality() {
  app::QualitySetting quality = app::parseQualitySettings("texels").front();
  quality.cost = app::Cost::lookupMilliseconds;
  return quality;
}

class Row {
 public:
  explicit Row(const Lit& lit)
      : lit_(lit), volume_(load(lit.path)), context_(render::OffscreenContext::create({})) {
    scene_.surfaces.front().value = lit.isovalue;
    scene_.light.environment.file = (test::dataFolder() / "hdr/grace_cathedral_1k.hdr").string();
  }

  void print() {
    const app::QualityStudy graphics = study(scene::Executor::gpu, scene_.gi.samples, kSize);
    const app::QualityStudy processor = study(scene::Executor::cpu, scene_.gi.samples, kSize);
    const app::QualityStudy quiet = study(scene::Executor::cpu, kNearlyNoNoise, kSizeOfSplit);
    const app::StudySetting &own = of(processor, "own"), &shown = of(processor, "auto");
    const app::LightErrors &e = shown.errors.light, &gl = of(graphics, "auto").errors.light;
    std::printf(
        "  %-24s %5.2f ±%.2f (%.1f)  %+5.2f ±%.2f  %5.2f  | %5.2f %5.2f | %5.2f %+5.2f | %7llu %5.2f  "
        "%5.2f\n",
        lit_.name, percent(e, e.rmse), percent(e, e.rmseStandardError), lit_.judged, percent(e, e.bias),
        percent(e, e.biasStandardError), percent(gl, gl.rmse), rmse(of(quiet, "auto")),
        rmse(of(quiet, "own")), rmse(own), percent(own.errors.light, own.errors.light.bias),
        static_cast<unsigned long long>(shown.light->texels),
        static_cast<double>(shown.light->texels) / static_cast<double>(own.light->texels),
        shown.frameMilliseconds / own.frameMilliseconds);
    std::fflush(stdout);
  }

 private:
  app::QualityStudy study(scene::Executor executor, int samples, glm::ivec2 size) {
    scene::Scene scene = scene_;
    scene.gi.samples = samples;
    base::Progress progress;
    return app::StudyRunner(context_->gl(), {volume_, scene, {.executor = executor}, size, 5})
        .study(texelsQuality(), progress, 0.0, 1.0);
  }
  static const app::StudySetting& of(const app::QualityStudy& study, std::string_view value) {
    for (const app::StudySetting& setting : study.settings)
      if (setting.value == value) return setting;
    throw std::logic_error("no such value of gi.texels");
  }
  static double percent(const app::LightErrors& errors, double error) {
    return 100.0 * errors.relative(error);
  }
  static double rmse(const app::StudySetting& setting) {
    return percent(setting.errors.light, setting.errors.light.rmse);
  }

  Lit lit_;
  VolumePointer volume_;
  std::unique_ptr<render::OffscreenContext> context_;
  scene::Scene scene_;
};

void run() {
  if (test::dataFolder().empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  std::printf(
      "  RMSE and bias in %% of the mean irradiance, gi.texels=shown (the default), hits of the processor "
      "and of\n"
      "  the graphics card; without noise, gi.texels=shown and own; gi.texels=own; texels, and the ratios "
      "of\n"
      "  texels and of a frame, shown to own\n");
  for (const Lit& lit : litSubjects()) Row(lit).print();
}

const Registration registration("stored_light",
                                "stored light against path tracing, and what its error is made of", run);

}  // namespace
}  // namespace isolux::bench
