// The frame graph: which passes a picture needs, and which of them must run again. No GL; testable anywhere.
//
// A pass declares the images it reads and writes and the parameters it depends on, each as a named hash. A
// pass that nobody reads, directly or through others, down to a requested image, is skipped. A pass whose
// parameters and inputs are those of its last run is cached. Everything else runs, in declared order.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "render/graph/frame.h"

namespace isolux::render {

// A setting ("camera.eye") or another input ("volume"), as a hash. The name is what --explain says.
struct Parameter {
  std::string name;
  std::uint64_t hash;
};

struct PassDeclaration {
  std::string name;
  std::vector<std::string> reads, writes;  // image names
  std::vector<Parameter> parameters;
  std::string notNeeded = {};  // why it is skipped; empty: because nothing reads what it writes
};

// Which of the passes somebody reads, directly or through others, down to a wanted image.
std::vector<bool> usedPasses(const std::vector<PassDeclaration>& passes,
                             const std::vector<std::string>& wanted);

struct PlannedPass {
  std::size_t index;  // in the declarations
  PassState state;
  std::string reason;
};

class FrameGraph {
 public:
  // The passes of this frame in an order where each image is written before it is read (asserted), and the
  // images wanted. Depends on these and on the memory of earlier frames only.
  std::vector<PlannedPass> plan(const std::vector<PassDeclaration>& passes,
                                const std::vector<std::string>& wanted);

  // Tells the graph that a planned pass has run; its outputs are now as new as its inputs.
  void completed(const PassDeclaration& pass);

  // Forgets the runs of one pass: what it wrote is gone.
  void forget(const std::string& pass) { memory_.erase(pass); }

  // Forgets all earlier frames (context lost, benchmark).
  void invalidate() {
    memory_.clear();
    versions_.clear();
  }

 private:
  struct LastRun {
    std::vector<Parameter> parameters;
    std::vector<std::pair<std::string, std::uint64_t>> inputs;  // image, version
  };
  // An image that one of several passes may write is another one with each of them.
  using Written = std::pair<std::string, std::string>;  // image, pass
  std::uint64_t versionOf(const std::string& image) const;
  std::map<std::string, LastRun> memory_;
  std::map<std::string, std::string> writers_;  // of each image, in the frame that was planned last
  std::map<Written, std::uint64_t> versions_;
  std::uint64_t clock_ = 0;
};

}  // namespace isolux::render
