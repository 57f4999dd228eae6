// Fills a light lattice on background threads by progressive refinement: requested texels first, in rounds of
// samples.
//
// Rounds end at 4, 16, 64, 256, 1024, then every 1024 samples per texel, and at the requested number. The
// unit of work is a block and a round; no two threads work on one block. A texel's mean is updated once per
// round: mean += (mean of the round - mean) * count / total. Splitting a round among calls of the estimator
// does not change it. The lattice is therefore bit-identical for any number of threads, any order of
// requests, and after stopping and resuming. A number of samples that ends no regular round (100) ends a
// round only while it is requested. If it is raised later, texels continue from there with the same samples,
// but summed in other groups. The last bits may then differ from those of a bake that had the higher number
// from the start.
//
// It calls no callbacks: owners poll counters() and LightLattice::changedSince(). All members are safe from
// any thread; only waitFor() and the destructor wait for a worker. An exception of an estimator ends the bake
// and is returned by failure().
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <vector>

#include "gi/bake/texel_estimator.h"
#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

struct BakeCounters {
  // Counts each texel once, over all requests. Texels count as requested until their isosurface turns out to
  // have no normal.
  std::uint64_t texelsWanted = 0, texelsDone = 0;    // done: have all samples
  std::uint64_t texelsStarted = 0;                   // have any
  std::uint64_t texelsLit = 0;                       // of all texels in the lattice
  std::uint64_t samplesWanted = 0, samplesDone = 0;  // paths
  // Visible texels (Priority::visible): their number, and how many have kSmoothSamples or all samples.
  std::uint64_t texelsSeen = 0, texelsSmooth = 0;
  std::uint64_t rays = 0;
  double seconds = 0.0;        // of work, without pauses and idle time
  double raysPerSecond = 0.0;  // over the last two seconds
  double secondsLeft = 0.0;    // at this speed
  int threads = 0;
  bool paused = false, idle = true;  // idle: every request is fulfilled (or none was made)
  bool takenIn = true;               // the counters include the latest requests
};

class LightBake {
 public:
  struct Options {
    std::uint32_t samples = 100;  // per texel at the end
    int threads = 1;
    // Gives the threads a tenth of the processor if other threads need it, for a window that must stay
    // responsive.
    bool background = false;
  };
  LightBake(std::shared_ptr<LightLattice> lattice, std::shared_ptr<const TexelEstimator> estimator,
            Options options);
  // Stops and waits until the threads have ended: rarely more than 100 ms, also on a busy machine. A window
  // uses base::destroyInBackground() instead.
  ~LightBake();
  void requestStop();  // permanent; does not wait

  // Replaces the requests of that priority; within it, blocks are served in the given order. A texel of
  // several priorities counts for the first; texels outside the lattice are ignored. Cheap enough for every
  // frame.
  void want(Priority request, std::vector<BlockRequest> blocks);
  // Sets the samples per texel. A higher number continues from the present ones; a lower one removes nothing.
  void setSamples(std::uint32_t samples);
  void setThreads(int threads);  // at most as many as the system creates: counters().threads
  void setPaused(bool paused);
  // Yields the processor to another task, such as a frame being drawn. Threads pause after their current call
  // until yield(false), but at most 250 ms after the first yield(true).
  void yield(bool yielding);

  BakeCounters counters() const;
  // Waits until every request is fulfilled up to `samples` per texel (0: all), an error, or the timeout [s].
  // Returns whether they are fulfilled.
  bool waitFor(std::uint32_t samples, double timeoutSeconds) const;
  // Returns the exception that ended the bake (a base::Error, std::bad_alloc or an internal error), or null.
  std::exception_ptr failure() const;
  const std::shared_ptr<LightLattice>& lattice() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::gi
