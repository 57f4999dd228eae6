// The pieces of a volume at the isovalues that somebody asked for last, and the voxels that a choice of
// pieces hides there: made when first asked, kept for a while, dropped before memory is refused.
//
// All members may be called from any thread; nobody waits for another's work.
#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/recent.h"
#include "scene/scene.h"
#include "volume/pieces/body.h"
#include "volume/pieces/pieces.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

class PieceSets {
 public:
  PieceSets(std::shared_ptr<const Grid> grid, std::shared_ptr<const MinMaxBlocks> blocks)
      : grid_(std::move(grid)), blocks_(std::move(blocks)) {}

  // Keeps what so many isosurfaces need, before and after a change.
  void expect(std::size_t isosurfaces) const;
  bool any() const;  // somebody has asked for pieces before
  // Null where nobody has asked for them, or long ago.
  std::shared_ptr<const Pieces> find(double isovalue, scene::Inside inside) const;
  // Throws Error: interrupted, memory.
  std::shared_ptr<const Pieces> at(double isovalue, scene::Inside inside, base::Progress& progress) const;

  // The body above an isovalue (scene::Pieces::within). Throws Error: interrupted, memory.
  std::shared_ptr<const Body> body(double isovalue, base::Progress& progress) const;
  // Tells whether all that a choice needs beside the pieces is known.
  bool knowsBody(const scene::Pieces& choice) const;
  // shownPieces() of these pieces. Throws as body() does.
  std::vector<bool> shown(const Pieces& pieces, const scene::Pieces& choice, base::Progress& progress) const;

  // What a scene's choice of pieces hides of one of its isosurfaces; null where the choice hides nothing of
  // it. Throws as at() does.
  std::shared_ptr<const VoxelMask> hidden(const scene::Pieces& choice, double isovalue, scene::Inside inside,
                                          base::Progress& progress) const;
  // The same where it is known already; nothing where it is not.
  std::optional<std::shared_ptr<const VoxelMask>> findHidden(const scene::Pieces& choice, double isovalue,
                                                             scene::Inside inside) const;

 private:
  static constexpr std::size_t kMostKept = 8;  // unless more are expected
  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const MinMaxBlocks> blocks_;
  mutable base::Recent<std::pair<double, scene::Inside>, std::shared_ptr<const Pieces>> pieces_{kMostKept};
  // Null where nothing is hidden.
  mutable base::Recent<std::tuple<scene::Pieces, double, scene::Inside>, std::shared_ptr<const VoxelMask>>
      hidden_{kMostKept};
  mutable base::Recent<double, std::shared_ptr<const Body>> bodies_{2};
};

// Of each isosurface of the scene that has something hidden; makes what is not there yet. Throws Error:
// interrupted; memory.
std::vector<HiddenOfSurface> hiddenOf(const scene::Scene& resolved, const PieceSets& pieces,
                                      base::Progress& progress);
// The same of what is known already: nobody waits.
std::vector<HiddenOfSurface> knownHidden(const scene::Scene& resolved, const PieceSets& pieces);
// Whether making takes no longer than a step of the isovalue.
bool hiddenIsReady(const scene::Scene& resolved, const PieceSets& pieces);

}  // namespace isolux::volume
