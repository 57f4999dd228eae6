#include "app/jobs/structure_job.h"

#include <utility>

#include "app/jobs/field_job.h"
#include "app/jobs/rest_scene.h"
#include "render/gl/gl_context.h"
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
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  scene::Machine machine;
  machine.executor = scene::Executor::cpu;  // the volume is on the graphics card once, for the user
  renderer.setMachine(machine);
  renderer.setVolume(subject.volume);
  render::FrameRequest request;
  request.size = marked.size;
  request.stop = progress.token();
  structure = hiddenStructure(renderer, shown, request, *subject.volume, *known.whole, *known.gaps, progress);
  paintStructure(*structure, shown.look.legendCorner, subject.taken, marked);
}

}  // namespace isolux::app
