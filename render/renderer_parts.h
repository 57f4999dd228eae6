// Holds what a renderer keeps between frames, and draws one frame (render/renderer.h).
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "render/passes/brick_rounds.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/readback.h"
#include "render/renderer.h"

namespace isolux::render {

// Times the passes of a frame: GPU timestamps, read when the frame is done; on a software rasteriser, whose
// own time is wall time, a clock around a finished pass.
class PassClock {
 public:
  explicit PassClock(GlPtr gl) : gl_(std::move(gl)) {}

  void begin() {
    begin_ = Clock::now();
    if (!gl_->software)
      gl_->QueryCounter(timers_.emplace_back(Query(gl_), Query(gl_)).first.id(), GL_TIMESTAMP);
  }
  void end(std::size_t reportIndex) {
    timed_.push_back(reportIndex);
    if (gl_->software)
      gl_->Finish();
    else
      gl_->QueryCounter(timers_.back().second.id(), GL_TIMESTAMP);
    wall_.push_back(1000.0 * base::secondsSince(begin_));
  }
  void write(std::vector<PassReport>& passes) const {
    for (std::size_t i = 0; i < timed_.size(); ++i) {
      double& milliseconds = passes[timed_[i]].milliseconds;
      milliseconds += gl_->software ? wall_[i] : millisecondsBetween(timers_[i].first, timers_[i].second);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  GlPtr gl_;
  Clock::time_point begin_;
  std::vector<std::pair<Query, Query>> timers_;
  std::vector<std::size_t> timed_;
  std::vector<double> wall_;
};

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
  std::size_t labelFields = 0;                 // VolumeState::labelFields
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
  // Takes the surfaces of the scene, and their volumes.
  void takeVolumes(const scene::Scene& scene);
  void requireFields(const scene::Scene& scene, const FrameRequest& request);
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
  // Plans which parts of the image are drawn in turn, if the frame keeps no images.
  void planBands();
  // Frees images that no pass from `next` on reads, until what is held and what `next` writes fit the budget.
  void makeRoom(std::size_t next);
  bool freeLargest(std::size_t next);
  // In a frame that keeps no images: frees those that no pass after this one reads.
  void freeAfter(std::size_t index);
  // Runs shade and resolve in turn, band by band.
  void runInBands(PassClock& clock);
  void runInBricks(const Pass& pass);  // which casts rays
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
