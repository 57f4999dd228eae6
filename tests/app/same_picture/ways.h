// Scenes that between them use every way of the program to a picture, and the ways to draw them.
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "app/accuracy/picture_errors.h"
#include "render/gl/gl_context.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::test {

struct PictureScene {
  const char* name;
  const char* volume;  // a phantom, or a file of shared/data/volumes
  int voxels;          // of the phantom per axis; 0: a file
  std::vector<std::string> settings;
};
void PrintTo(const PictureScene& scene, std::ostream* out);
std::span<const PictureScene> pictureScenes();
scene::Scene sceneOf(const PictureScene& scene);  // not resolved

// What the machine may do; the reference is Way{}: the processor with its widest instruction set, all
// threads, the volume as a whole.
struct Way {
  scene::Executor executor = scene::Executor::cpu;
  scene::MemoryLayout layout = scene::MemoryLayout::whole;
  int threads = 0;            // of everything; 0: as many as there are
  std::int64_t setsLeft = 0;  // instruction sets as Highway numbers them; 0: all
};

// While it lives code that asks Highway for an instruction set gets one of these alone. 0: no limit.
class InstructionSetsLeft {
 public:
  explicit InstructionSetsLeft(std::int64_t sets);
  ~InstructionSetsLeft();
  InstructionSetsLeft(const InstructionSetsLeft&) = delete;
  InstructionSetsLeft& operator=(const InstructionSetsLeft&) = delete;
};

struct DrawnWay {
  render::ColorImage color;
  render::AovImage hit, voxel, normal;
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // nothing automatic is left in it
  int hits = 0;        // pixels
  bool castOnProcessor = false;
  app::DrawnHits drawnHits;
};

// Everything anew: the volume, what is derived from it, the light, the renderer. 192 x 144 pixels.
DrawnWay drawWay(render::OffscreenContext& context, const PictureScene& scene, const Way& way = {});
// The same of another scene than the table's; its volume is that of `of`.
DrawnWay drawWay(render::OffscreenContext& context, const PictureScene& of, const scene::Scene& scene,
                 const Way& way = {});

}  // namespace isolux::test
