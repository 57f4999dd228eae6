#include "app/jobs/structure_job.h"

#include <utility>

#include "app/picture/field_job.h"
#include "app/picture/quiet_renderer.h"
#include "app/picture/rest_scene.h"
#include "scene/rules/ghosts.h"

namespace isolux::app {

void StructureWork::run(base::Progress& progress) {
  KnownStructure& known = subject.known;
  if (!known.whole) {
    auto found = volume::indexedVolume(subject.scene.source, progress);
    if (!found) return;
    known = {std::make_shared<const volume::IndexedVolume>(std::move(*found)), nullptr, {}};
  }
  marked = subject.picture();
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
  request.size = marked.size;
  request.stop = progress.token();
  structure =
      hiddenStructure(quiet.renderer(), shown, request, *subject.volume, *known.whole, *known.gaps, progress);
  legend = paintStructure(*structure, shown.look.legendCorner, subject.taken, marked);
}

}  // namespace isolux::app
