#include "tests/app/same_picture/ways.h"

#include <optional>

#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <tbb/global_control.h>

#include "app/light/light_controller.h"
#include "app/ready/ready_fields.h"
#include "render/renderer.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"

namespace isolux::test {

namespace {

const std::vector<PictureScene> kScenes = {
    {"ct",
     "ct_head_pitch.nii.gz",
     0,
     {"look.mode=blinn_phong", "isosurface.value=200", "camera.eye=60,-190,60"}},
    {"cubic", "gyroid", 64, {"look.mode=lambert", "hit.field=cubic", "camera.eye=40,-120,50"}},
    {"interpolating",
     "head",
     64,
     {"look.mode=blinn_phong", "hit.field=cubic_interpolating", "derivatives.field=cubic_interpolating",
      "camera.projection=orthographic", "camera.eye=90,-480,50"}},
    {"curvature", "head", 64, {"look.mode=mean_curvature", "camera.eye=90,-480,50"}},
    {"scales",
     "marschner_lobb",
     48,
     {"look.mode=curvature_2d", "derivatives.scale=1.5", "derivatives.normal_scale=1",
      "camera.eye=50,-75,110"}},
    {"layers",
     "head",
     64,
     {"look.mode=blinn_phong", "isosurface.value=-300", "isosurface.opacity=0.45", "isosurface2.shown=1",
      "isosurface2.value=400", "isosurface2.opacity=0.6", "isosurface3.shown=1", "isosurface3.value=1500",
      "isosurface.facing_opacity=0.5", "camera.eye=90,-480,50"}},
    {"light",
     "head",
     48,
     {"look.mode=gi", "isosurface.value=300", "gi.samples=16", "lamp1.shown=1", "lamp1.kind=sphere",
      "camera.eye=90,-480,50"}},
    {"cuts",
     "head",
     64,
     {"look.mode=lambert", "clip.planes=0,0,40 0.2,-0.5,1", "clip.box=-70,-110,-90; 80,90,110",
      "clip.box_rotation=0.98,0,0,0.2", "clip.removed=30,-999,0; 999,0,999", "clip.cap=inside",
      "isosurface2.shown=1", "isosurface2.value=-300", "isosurface2.clipped=0", "camera.eye=150,-350,250"}},
    {"lines",
     "head",
     64,
     {"look.mode=lambert", "look.ridges=0.8", "look.contours=1", "look.suggestive_contours=1",
      "look.background_top=1,1,1", "look.background_bottom=1,1,1", "camera.eye=90,-480,50"}},
    {"shadow",
     "head",
     64,
     {"look.mode=lambert", "look.shadow=0.8", "light.direction=-1,1,0.4", "camera.eye=90,-480,50"}},
    {"transfer",
     "head",
     48,
     {"look.mode=gi", "isosurface.value=300", "gi.samples=16", "gi.mode=transfer", "camera.eye=90,-480,50"}},
    {"edge",
     "ct_head_pitch.nii.gz",
     0,
     {"look.mode=edge_offset", "isosurface.value=150", "derivatives.field=cubic_interpolating"}},
    {"pieces",
     "engine_crop.mhd",
     0,
     {"look.mode=curvedness", "isosurface.value=80", "pieces.keep=2", "isosurface.opacity=0.5"}},
    {"sampled", "head", 64, {"look.mode=gaussian_curvature", "hit.method=sampled", "derivatives.fetch=fast"}},
    {"flow", "saddle", 48, {"look.mode=flow", "flow.length=30", "camera.eye=50,-75,90"}},
};

std::shared_ptr<const volume::PreparedVolume> volumeOf(const PictureScene& scene) {
  if (scene.voxels > 0) return phantom(scene.volume, scene.voxels);
  scene::Source source;
  source.path = (dataFolder() / "volumes" / scene.volume).string();
  base::Progress progress;
  return volume::loadVolume(source, progress);
}

std::shared_ptr<const gi::PictureLight> lightOf(const scene::Scene& scene,
                                                const std::shared_ptr<const volume::PreparedVolume>& volume,
                                                gi::VisiblePointSet seen, int threads) {
  app::LightController light({.threads = threads > 0 ? std::optional(threads) : std::nullopt});
  light.setScene(scene, volume);
  light.setVisible(std::move(seen));
  base::Progress progress;
  EXPECT_TRUE(light.finish(progress, 240.0));
  return light.light();
}

}  // namespace

void PrintTo(const PictureScene& scene, std::ostream* out) {
  *out << scene.name;
}

std::span<const PictureScene> pictureScenes() {
  return kScenes;
}

scene::Scene sceneOf(const PictureScene& scene) {
  scene::Scene result;
  result.camera.frames = scene::Frames::volume;
  result.isosurface.suggestion = scene::Suggestion::contrast;
  for (const std::string& setting : scene.settings) scene::applyAssignment(result, setting);
  return result;
}

InstructionSetsLeft::InstructionSetsLeft(std::int64_t sets) {
  hwy::SetSupportedTargetsForTest(sets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

InstructionSetsLeft::~InstructionSetsLeft() {
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

DrawnWay drawWay(render::OffscreenContext& context, const PictureScene& scene, const Way& way) {
  return drawWay(context, scene, sceneOf(scene), way);
}

DrawnWay drawWay(render::OffscreenContext& context, const PictureScene& of, const scene::Scene& wanted,
                 const Way& way) {
  const InstructionSetsLeft sets(way.setsLeft);
  std::optional<tbb::global_control> limit;
  if (way.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(way.threads));
  const auto volume = volumeOf(of);
  base::Progress progress;
  scene::Scene scene = scene::resolve(wanted, volume->facts);
  app::completeFields(scene, *volume, true, progress);
  context.makeCurrent();
  render::Renderer renderer(context.gl());
  renderer.setHostSettings({.memory = {2048, way.layout}, .executor = way.executor});
  renderer.setVolume(volume);
  using render::Aov;
  render::FrameRequest request;
  request.size = {192, 144};
  request.aovs = {Aov::hit, Aov::voxel, Aov::normal, Aov::depth};
  render::FrameReport report = renderer.render(scene, request);
  if (scene.look.mode == scene::LookMode::gi) {
    renderer.setLight(lightOf(scene, volume, renderer.hitVoxels(), way.threads));
    report = renderer.render(scene, request);
  }
  DrawnWay drawn{.color = renderer.readColor(),
                 .hit = renderer.readAov(Aov::hit),
                 .voxel = renderer.readAov(Aov::voxel),
                 .normal = renderer.readAov(Aov::normal),
                 .volume = volume,
                 .scene = scene,
                 .drawnHits = {}};
  for (const float hit : drawn.hit.values) drawn.hits += hit != 0.0f;
  for (const render::PassReport& pass : report.passes)
    drawn.castOnProcessor = drawn.castOnProcessor || (pass.name == "cast" && pass.onProcessor);
  EXPECT_EQ(report.bricks.missing, 0.0);
  const std::vector<float> depth = renderer.readAov(Aov::depth).values;
  drawn.drawnHits = {request.size, depth, drawn.voxel.values, drawn.castOnProcessor};
  return drawn;
}

}  // namespace isolux::test
