// Determines which passes a frame needs, and which of them must run again. No GL; testable anywhere.
//
// A pass declares the images it reads and writes and the parameters it depends on, each as a named hash. A
// pass from which no chain of reads leads to a requested image is skipped. A pass is cached if its parameters
// and inputs equal those of its last run. All others run, in declared order.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/graph/frame.h"

namespace isolux::render {

// The hash of a setting ("camera.eye") or another input ("volume"). --explain shows the name.
struct Parameter {
  std::string name;
  std::uint64_t hash;
};

struct PassDeclaration {
  std::string name;
  std::vector<std::string> reads, writes;  // image names
  std::vector<Parameter> parameters;
  std::string notNeeded = {};  // why it is skipped; empty: because no pass reads its images
  // Bytes per ray of each image in `writes`; 0: it has no size of the rays. kSameImage: it is another name of
  // the image before it. Empty: all are 0.
  std::vector<int> bytes = {};
  static constexpr int kSameImage = -1;
};

// Returns which passes a wanted image depends on, directly or through other passes.
std::vector<bool> usedPasses(const std::vector<PassDeclaration>& passes,
                             const std::vector<std::string>& wanted);

struct PlannedPass {
  std::size_t index;  // in the declarations
  PassState state;
  std::string reason;
  bool remade = false;  // it ran before with the same inputs, but its images were freed
};

// Returns for each image the index of the last running pass that reads or writes it, passes.size() for those
// in `wanted`, and nothing for images that no running pass touches: afterwards the image may be freed.
std::map<std::string, std::size_t> lastUses(const std::vector<PassDeclaration>& passes,
                                            const std::vector<PlannedPass>& plan,
                                            const std::vector<std::string>& wanted);

// Returns the bytes per ray of the images that are held at the same time at most, if each is freed after its
// last reader and all passes run.
int peakBytesPerRay(const std::vector<PassDeclaration>& passes, const std::vector<std::string>& wanted);

class FrameGraph {
 public:
  // Plans a frame. Requires that `passes` are in an order where each image is written before it is read
  // (asserted). The result depends only on the arguments and on earlier frames.
  std::vector<PlannedPass> plan(const std::vector<PassDeclaration>& passes,
                                const std::vector<std::string>& wanted);

  // Records that a planned pass has run; its outputs are now as new as its inputs.
  void completed(const PassDeclaration& pass);

  // Discards the runs of one pass: its images are lost.
  void forget(const std::string& pass) { memory_.erase(pass); }

  // Records that images of a pass were freed. The pass runs again only for passes that run and read them, or
  // if they are wanted; passes that have read them before stay cached.
  void freed(const std::string& pass) {
    if (memory_.count(pass) > 0) freed_.insert(pass);
  }

  // Discards all earlier frames (context lost, benchmark).
  void invalidate() {
    memory_.clear();
    versions_.clear();
    freed_.clear();
  }

 private:
  struct LastRun {
    std::vector<Parameter> parameters;
    std::vector<std::pair<std::string, std::uint64_t>> inputs;  // image, version
  };
  // An image written by one of several passes counts as a different image for each of them.
  using Written = std::pair<std::string, std::string>;  // image, pass
  std::uint64_t versionOf(const std::string& image) const;
  void remakeFreed(const std::vector<PassDeclaration>& passes, const std::vector<std::string>& wanted,
                   std::vector<PlannedPass>& planned) const;
  std::map<std::string, LastRun> memory_;
  std::set<std::string> freed_;                 // passes whose images are not all there
  std::map<std::string, std::string> writers_;  // of each image, in the last planned frame
  std::map<Written, std::uint64_t> versions_;
  std::uint64_t clock_ = 0;
};

}  // namespace isolux::render
