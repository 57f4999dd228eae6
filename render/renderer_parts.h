// Holds what a renderer keeps between frames, and draws one frame (render/renderer.h).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/pass_clock.h"
#include "render/passes/brick_rounds.h"
#include "render/passes/pass_list.h"
#include "render/passes/readback.h"
#include "render/renderer.h"

namespace isolux::render {

struct Renderer::Parts {
  explicit Parts(const GlPtr& gl) : frame(gl), passes(makePasses()) {}

  FrameState frame;
  PassList passes;
  FrameGraph graph;
  FrameReport report;
  DrawnFrame drawn;
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::optional<scene::Scene> completedScene;  // of completed()
  scene::Memory memory;
  scene::Executor executor = scene::Executor::automatic;
  std::uint64_t copiesMade = 0;                // VolumeState::made
  std::uint64_t bricksAsked = 0;               // BrickState::asked
  BrickRounds::Unfinished unfinished;          // of the last frame that cast rays
  bool hit = false;                            // some ray of the last frame that cast rays hit a surface
  bool hitsChanged = false;                    // since the last frame that was completed
  bool complete = true;                        // the last frame had all the time it needed
  bool imagesDropped = false;                  // in this frame, because their size is another
  std::size_t imageBudget = 0;                 // bytes
  std::vector<PassDeclaration> declared;       // of this frame, in the order of `passes`
  std::vector<PlannedPass> planned;            // of this frame, the same
  std::map<std::string, std::size_t> lastUse;  // of each image in this frame: render::lastUses()

  // With what is automatic about derivatives where the picture reads them and nobody has filled it in.
  const scene::Scene& completed(const scene::Scene& scene, const FrameRequest& request);
  void prepare(const scene::Scene& scene, const FrameRequest& request);
  // Blocks of other sizes are those of benchmarks.
  bool hasMasks() const { return volume->blocks->blockCells() == volume::BoxBounds::kBlockCells; }
  VolumeState volumeState() const;
  BrickState brickState();
  std::size_t volumeBytes() const;
  // Returns what is left of memory.gpu_budget_mb, but a quarter in any case: a cache of bricks takes all.
  std::size_t budgetWithout(std::size_t taken) const;
  // Returns what volume and light leave of it; of a software driver, whose images are in main memory, at most
  // half of what is left there.
  std::size_t budgetOfImages() const;
  void plan();
  // Draws the frame that was prepared.
  void draw();
  void run(const PlannedPass& now, PassClock& clock);
  void planMemory();
  // Of a frame that keeps no images: which parts of images are drawn in turn.
  void planBands();
  // Frees images that no pass from `next` on reads, until what is held and what `next` writes fit the budget.
  void makeRoom(std::size_t next);
  bool freeLargest(std::size_t next);
  // In a frame that keeps no images: frees those that no pass after this one reads.
  void freeAfter(std::size_t index);
  // Runs shade and resolve in turn, band by band.
  void runInBands(PassClock& clock);
  void runInBricks(Pass& pass);  // which casts rays
  void reportBricks();
  void writeReport();
  // A frame has ended before it was complete. Stopped: the passes that were complete are good for the next
  // one; otherwise nothing that was drawn is still there.
  void leave(bool stopped);
  void endFrame();
  void noteHits();      // after a pass that found some
  void forgetImages();  // after a frame that keeps none
  std::size_t indexOf(std::string_view pass) const;
  std::size_t bytesOf(std::size_t pass) const;
};

}  // namespace isolux::render
