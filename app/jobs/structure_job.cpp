#include "app/jobs/structure_job.h"

#include <utility>

#include "app/jobs/give_way.h"
#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"
#include "scene/rules/ghosts.h"

namespace isolux::app {

namespace {

FoundStructure lookFor(const StructureSubject& subject, base::Progress& progress) {
  FoundStructure found{{}, {}, subject.known};
  KnownStructure& known = found.known;
  if (!known.whole) {
    auto whole = volume::indexedVolume(subject.scene.source, progress);
    if (!whole) return found;
    known = {std::make_shared<const volume::IndexedVolume>(std::move(*whole)), nullptr, {}};
  }
  found.marked.image = subject.picture();
  scene::Scene shown = subject.scene;
  completeFields(shown, *subject.volume, true, progress);
  shown = atRest(std::move(shown), *subject.volume, progress);
  std::vector<double> isovalues = scene::seenIsovalues(shown);
  if (!known.gaps || known.isovalues != isovalues) {
    known.gaps =
        std::make_shared<const volume::LevelGaps>(*known.whole, subject.volume->grid(), isovalues, progress);
    known.isovalues = std::move(isovalues);
  }
  QuietRenderer quiet(subject.volume, nullptr);
  render::FrameRequest request;
  request.size = found.marked.image.size;
  request.stop = progress.token();
  found.structure =
      hiddenStructure(quiet.renderer(), shown, request, *subject.volume, *known.whole, *known.gaps, progress);
  found.marked.legend =
      paintStructure(*found.structure, shown.look.legendCorner, subject.taken, found.marked.image);
  return found;
}

}  // namespace

std::unique_ptr<StructureTask> structureTask(StructureSubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress& progress) {
    giveWay();
    return lookFor(subject, progress);
  };
  return StructureTask::start({"", "look for structure lost in the overview"}, work);
}

}  // namespace isolux::app
