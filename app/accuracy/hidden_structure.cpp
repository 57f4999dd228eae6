#include "app/accuracy/hidden_structure.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/accuracy/overlay_painter.h"
#include "app/ready/give_way.h"
#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"
#include "app/view_math/surface_pick.h"
#include "base/number_text.h"
#include "render/passes/view_uniforms.h"
#include "render/still_picture.h"
#include "scene/camera.h"
#include "scene/rules/ghosts.h"
#include "volume/clip/surface_cut.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::app {

namespace {

std::string thinText(double mm) {
  return base::shortText(mm, 3) + " mm";
}

FoundStructure lookFor(const StructureSubject& subject, base::Progress& progress) {
  FoundStructure found{{}, {}, subject.known};
  KnownStructure& known = found.known;
  if (!known.whole) {
    auto whole = volume::indexedVolume(subject.scene.source, progress);
    if (!whole) return found;
    known = {std::make_shared<const volume::IndexedVolume>(std::move(*whole)), nullptr, {}};
  }
  found.marked.image = subject.picture();
  ShownPicture shown{subject.volume, subject.scene, nullptr, found.marked.image.size};
  completeFields(shown.scene, *shown.volume, true, progress);
  shown.scene = atRest(std::move(shown.scene), *shown.volume, progress);
  std::vector<double> isovalues = scene::seenIsovalues(shown.scene);
  if (!known.gaps || known.isovalues != isovalues) {
    known.gaps = std::make_shared<const volume::LostStructure>(*known.whole, shown.volume->grid(), isovalues,
                                                               progress);
    known.isovalues = std::move(isovalues);
  }
  QuietRenderer quiet(shown.volume, nullptr);
  found.structure = hiddenStructure(*quiet, shown, *known.whole, *known.gaps, progress);
  found.marked.legend =
      paintStructure(*found.structure, shown.scene.look.legendCorner, subject.taken, found.marked.image);
  return found;
}

}  // namespace

double HiddenStructure::share() const {
  if (hides.empty()) return 0.0;
  return static_cast<double>(std::ranges::count(hides, std::uint8_t{1})) / static_cast<double>(hides.size());
}

HiddenStructure hiddenStructure(render::Renderer& renderer, const ShownPicture& drawn,
                                const volume::IndexedVolume& whole, const volume::LostStructure& gaps,
                                base::Progress& progress) {
  const glm::ivec2 size = drawn.size;
  const std::size_t count = volume::Extent2{size}.count();
  const volume::GridGeometry& level = drawn.volume->grid().geometry();
  const glm::dvec3 thin = 2.0 * level.spacingMm();
  HiddenStructure out{size, std::vector<std::uint8_t>(count, 0), std::vector<std::uint8_t>(count, 0), 0,
                      std::max({thin.x, thin.y, thin.z})};
  const std::vector<double> isovalues = scene::seenIsovalues(drawn.scene);
  out.blocks = gaps.count();

  const render::FrameRequest hits{
      .size = size, .color = false, .aovs = {render::Aov::voxel}, .stop = progress.token()};
  const std::vector<float> voxels =
      render::drawStill(renderer, drawn.scene, hits, progress).aovs.at(0).values;

  const scene::CameraFrame frame = scene::frameOf(drawn.scene.camera);
  const double aspect = static_cast<double>(size.x) / size.y;
  const double startMm = render::ViewUniforms(drawn.scene.camera, aspect, level).rayStartMm;
  const glm::dmat4 wholeFromLevel = glm::inverse(whole.geometry.worldFromVoxel) * level.worldFromVoxel;
  const volume::SurfaceCut cut(drawn.scene, whole.geometry);
  // Of those that are cut the same is left; of another, all.
  double leastCut = isovalues.empty() ? 0.0 : isovalues.front();
  for (const double isovalue : isovalues)
    if (!cut.cuts(isovalue)) leastCut = isovalue;
  volume::parallelSteps(
      static_cast<std::size_t>(size.y), progress, {0.0, 1.0, "looking for structure lost in the level"},
      [&](std::size_t y) {
        for (int x = 0; x < size.x; ++x) {
          const std::size_t i = y * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
          const glm::dvec2 ndc((x + 0.5) / size.x * 2.0 - 1.0,
                               1.0 - (static_cast<double>(y) + 0.5) / size.y * 2.0);
          volume::Ray ray = viewRay(whole.geometry, frame, ndc, aspect, startMm);
          const glm::dvec3 hit(voxels[3 * i], voxels[3 * i + 1], voxels[3 * i + 2]);
          out.seen[i] = std::isnan(hit.x) ? 0 : 1;
          if (out.seen[i])
            ray.tMaximum =
                glm::dot(glm::dvec3(wholeFromLevel * glm::dvec4(hit, 1.0)) - ray.origin, ray.direction) /
                glm::dot(ray.direction, ray.direction);
          for (const auto& [begin, end] : cut.segmentsOf(leastCut, ray)) {
            ray.tMinimum = begin;
            ray.tMaximum = end;
            if (begin < end && gaps.on(ray)) out.hides[i] = 1;
          }
        }
      });
  return out;
}

std::string structureLine(const HiddenStructure& structure) {
  return "the level may hide structure thinner than " + thinText(structure.thinnestMm) + " in " +
         base::shortText(100.0 * structure.share(), 3) + " % of the image (" +
         std::to_string(structure.blocks) + " blocks of 8x8x8 cells)";
}

std::optional<render::Tile> paintStructure(const HiddenStructure& structure, scene::LegendCorner corner,
                                           const std::optional<render::Tile>& taken,
                                           render::ColorImage& image) {
  if (structure.share() == 0.0) return std::nullopt;
  OverlayPainter painter(image);
  painter.hatch(structure.hides);
  render::Legend legend;
  legend.quantity = "Coarser level";
  legend.hatched = {"may hide structure", "thinner than " + thinText(structure.thinnestMm)};
  return painter.addLegend(legend, corner, structure.seen, taken);
}

std::unique_ptr<StructureTask> structureTask(StructureSubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress& progress) {
    giveWay();
    return lookFor(subject, progress);
  };
  return StructureTask::start({"", "look for structure lost in the overview"}, work);
}

}  // namespace isolux::app
