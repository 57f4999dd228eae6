// Fills a light lattice on background threads: what is wanted first comes first, in rounds of samples, so
// that light is there soon and becomes better everywhere at once.
//
// Rounds end at 4, 16, 64, 256, 1024, then every 1024 samples per texel, and at the number asked for. The
// unit of work is a block and a round; no two threads work on one block. A texel's mean is updated once a
// round, mean += (mean of the round - mean) * count / total, however the round is cut among calls of the
// estimator. So the lattice is the same, bit for bit, for any number of threads, any order of wishes, and
// after stopping and going on. A number of samples that no round ends at (100) is a round's end only while it
// is asked for: raised later, texels go on from there, with the same samples as ever but summed in other
// groups, so that the last bits may differ from those of a bake that had the higher number from the start.
//
// Nothing calls back: owners poll counters() and LightLattice::changedSince(). All members are safe from any
// thread, and none but waitFor() and the destructor waits for a worker. Exceptions of an estimator end the
// bake and are kept as failure().
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <vector>

#include "gi/bake/texel_estimator.h"
#include "gi/bake/wish.h"
#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

struct BakeCounters {
  // Of all wishes, each texel once; those whose isosurface has no normal are wanted until that is known.
  std::uint64_t texelsWanted = 0, texelsDone = 0;    // done: have all samples
  std::uint64_t texelsStarted = 0;                   // have any
  std::uint64_t texelsLit = 0;                       // of all that are in the lattice
  std::uint64_t samplesWanted = 0, samplesDone = 0;  // paths
  // Of those that are seen (Wish::visible): how many there are, and have kSmoothSamples, or all.
  std::uint64_t texelsSeen = 0, texelsSmooth = 0;
  std::uint64_t rays = 0;
  double seconds = 0.0;        // at work, not paused or idle
  double raysPerSecond = 0.0;  // of late
  double secondsLeft = 0.0;    // at this rate
  int threads = 0;
  bool paused = false, idle = true;  // idle: every wish is fulfilled (or none was made)
  bool takenIn = true;               // these are of the last wishes
};

class LightBake {
 public:
  struct Options {
    std::uint32_t samples = 100;  // per texel in the end
    int threads = 1;
    // Threads get a tenth of the processor where others want it: for a window that must stay fluent.
    bool background = false;
  };
  LightBake(std::shared_ptr<LightLattice> lattice, std::shared_ptr<const TexelEstimator> estimator,
            Options options);
  // Stops and waits until the threads have ended: rarely more than 100 ms, also beside busy processes. A
  // window leaves that to base::retire().
  ~LightBake();
  void requestStop();  // for good; does not wait

  // Replaces the wishes of that kind; within it, blocks are served in the order given. Texels of several
  // kinds count as the first; what is not in the lattice is passed over. Cheap enough for every frame.
  void want(Wish wish, std::vector<WantedBlock> blocks);
  // More samples go on where the texels are; fewer leave what there is.
  void setSamples(std::uint32_t samples);
  void setThreads(int threads);  // as many as the system gives: counters().threads
  void setPaused(bool paused);
  // Someone else needs the processor now (a frame is drawn): threads wait after the call that they are at,
  // until yield(false), but no longer than 250 ms after the first yield(true).
  void yield(bool yielding);

  BakeCounters counters() const;
  // Waits until every wish is fulfilled up to `samples` per texel (0: all), an error, or the timeout; true if
  // fulfilled.
  bool waitFor(std::uint32_t samples, double timeoutSeconds) const;
  // What ended the bake: a base::Error, std::bad_alloc, or a mistake of our own. Null: nothing has.
  std::exception_ptr failure() const;
  const std::shared_ptr<LightLattice>& lattice() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::gi
