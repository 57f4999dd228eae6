// The images of render/renderer.h: which are freed, and which are drawn part by part.
#include <algorithm>

#include "render/passes/light_passes.h"
#include "render/passes/pass_declarations.h"
#include "render/renderer_parts.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

constexpr const char* kEndOfLayers = " layer";  // of the names of images behind transparent surfaces

// Colours need not be there as a whole where resolve is their only reader, and reads only those of hits.
bool shadesInBands(const FrameState& frame) {
  const scene::Scene& scene = *frame.scene;
  return frame.request.color && !frame.request.linear && !scene::isTransparent(scene) &&
         !scene::showsLegend(scene) && !scene.picture.transparent && !scene::usesGi(scene) &&
         !frame.cutFaceColors;
}

}  // namespace

std::size_t Renderer::Parts::volumeBytes() const {
  std::size_t sum = 0;
  for (const auto& one : frame.volumes) sum += one->bytes();
  return sum;
}

std::size_t Renderer::Parts::budgetWithout(std::size_t taken) const {
  const std::size_t budget = static_cast<std::size_t>(memory.gpuBudgetMb) << 20;
  return std::max(budget / 4, budget - std::min(budget, taken));
}

std::size_t Renderer::Parts::budgetOfImages() const {
  const std::size_t share = budgetWithout(volumeBytes() + frame.lighting->bytes());
  return frame.gl->software ? std::min(share, (base::machineMemory().left() + frame.images.bytes()) / 2)
                            : share;
}

void Renderer::Parts::planMemory() {
  std::vector<std::string> atEnd = wantedImages(frame.request, *frame.scene);
  if (frame.request.keepImages) atEnd.insert(atEnd.end(), {image::surface, image::color});  // to read back
  lastUse = lastUses(declared, planned, atEnd);
  if (!frame.request.keepImages) {  // nothing of earlier frames is left but what tiles share
    for (const PassDeclaration& pass : declared)
      for (const std::string& image : pass.writes) frame.images.drop(image);
    frame.images.dropEnding(kEndOfLayers);
    frame.images.dropFree();
    frame.host.clear();
  }
  frame.images.beginPeak();
  if (!frame.request.keepImages && shadesInBands(frame)) planBands();
}

void Renderer::Parts::planBands() {
  constexpr int pixels = 64;
  frame.bandRows = pixels * frame.request.supersampling;
  for (auto& [image, last] : lastUse)
    if (last == indexOf(pass::shade)) last = indexOf(pass::resolve);
  const bool drawn = planned[indexOf(pass::gradient)].state == PassState::ran;
  frame.gradientInStrips = frame.onProcessor.all && !frame.gradientShared && drawn;
  for (const PlannedPass& one : planned) {
    const PassDeclaration& pass = declared[one.index];
    const bool reads = std::find(pass.reads.begin(), pass.reads.end(), image::gradient) != pass.reads.end();
    const auto inStrips = {pass::openness, pass::shadow, pass::shade};
    if (one.state != PassState::skipped && reads &&
        std::find(inStrips.begin(), inStrips.end(), pass.name) == inStrips.end())
      frame.gradientInStrips = false;
  }
}

bool Renderer::Parts::freeLargest(std::size_t next) {
  const std::string* largest = nullptr;
  std::size_t writer = 0, most = 0;
  for (std::size_t i = 0; i < declared.size(); ++i)
    for (std::size_t k = 0; k < declared[i].writes.size(); ++k) {
      const std::string& image = declared[i].writes[k];
      const auto last = lastUse.find(image);
      if (declared[i].bytes[k] <= 0 || (last != lastUse.end() && last->second >= next)) continue;
      const std::size_t bytes = frame.images.bytesOf(image);
      if (bytes <= most) continue;
      most = bytes;
      largest = &image;
      writer = i;
    }
  if (!largest) return false;
  frame.images.drop(*largest);
  frame.images.dropFree();
  graph.freed(declared[writer].name);
  return true;
}

void Renderer::Parts::makeRoom(std::size_t next) {
  // In bricks, what is freed could be made again only from bricks that may be gone.
  if (!frame.request.keepImages || frame.bricks()) return;
  std::size_t more = 0;
  if (next < declared.size())
    for (std::size_t k = 0; k < declared[next].writes.size(); ++k)
      if (declared[next].bytes[k] > 0 && !frame.images.has(declared[next].writes[k]))
        more += static_cast<std::size_t>(declared[next].bytes[k]) *
                static_cast<std::size_t>(frame.raySize().x) * static_cast<std::size_t>(frame.raySize().y);
  if (frame.images.bytes() + more <= imageBudget) return;
  frame.images.dropEnding(kEndOfLayers);
  frame.images.dropFree();
  while (frame.images.bytes() + more > imageBudget && freeLargest(next)) {
  }
}

void Renderer::Parts::freeAfter(std::size_t index) {
  if (frame.request.keepImages) return;
  if (passes[index].name == pass::layers) frame.images.dropEnding(kEndOfLayers);
  for (const auto& [image, last] : lastUse) {
    if (last != index) continue;
    frame.images.drop(image);
    releaseHostImages(frame, image);
  }
}

}  // namespace isolux::render
