// Finds what a coarser level hides of the picture on screen (app/accuracy/hidden_structure.h) and marks it,
// on a background thread, with a renderer of its own that casts on the processor.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/accuracy/hidden_structure.h"
#include "app/jobs/quiet_job.h"

namespace isolux::app {

// What outlives a picture: the next job of the same volume takes it over. All null: nothing is known yet.
struct KnownStructure {
  std::shared_ptr<const volume::IndexedVolume> whole;
  std::shared_ptr<const volume::LevelGaps> gaps;  // of `isovalues`
  std::vector<double> isovalues;
};

struct StructureWork {
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;  // the level
    scene::Scene scene;                                    // resolved, as it is shown in motion
    std::function<render::ColorImage()> picture;           // copied out on the thread
    std::optional<render::Tile> taken;                     // by the picture's own legend
    KnownStructure known;
  };
  static constexpr const char* kDoes = "look for structure lost in the overview";
  void run(base::Progress& progress);

  Subject subject;
  std::optional<HiddenStructure> structure{};  // none: the volume has no index
  render::ColorImage marked{};
  std::optional<render::Tile> legend{};  // where it stands in it
};

class StructureJob : public QuietJob<StructureWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error.
  const std::optional<HiddenStructure>& structure() const { return work().structure; }
  const render::ColorImage& marked() const { return work().marked; }
  const std::optional<render::Tile>& legend() const { return work().legend; }
  const KnownStructure& known() const { return work().subject.known; }
};

}  // namespace isolux::app
