// A second volume that colours the surface of the first (color.volume): read when something first asks for
// it, and kept beside the first.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/volume.h"

namespace isolux::volume {

struct SecondVolume {
  Volume volume;
  std::shared_ptr<const Coefficients> coefficients;  // of cubic_interpolating; null: nobody has asked

  const Grid& grid() const { return *volume.grid; }
};

// Keeps the one that was asked for last. All members may be called from any thread.
class SecondVolumes {
 public:
  explicit SecondVolumes(std::shared_ptr<const Grid> first) : first_(std::move(first)) {}

  // Null where there is none, or it is not read yet.
  std::shared_ptr<const SecondVolume> find(const scene::ColorVolume& color) const;
  // Reads it where it is not there yet; takes long. Phantoms without a size are made on the first one's grid.
  // Null where color.volume is empty. Throws Error{input, memory, interrupted}.
  std::shared_ptr<const SecondVolume> make(const scene::ColorVolume& color, base::Progress& progress);

 private:
  struct Key {
    std::string path, raw;
    int component = 0, timeStep = 0;
    bool operator==(const Key&) const = default;
  };
  static Key keyOf(const scene::ColorVolume& color);
  std::shared_ptr<const SecondVolume> fresh(const scene::ColorVolume& color, base::Progress& progress) const;

  std::shared_ptr<const Grid> first_;
  mutable std::mutex mutex_;  // held for moments
  Key key_;
  std::shared_ptr<const SecondVolume> kept_;
};

}  // namespace isolux::volume
