#include "volume/prepared/surface_crossings.h"

namespace isolux::volume {

std::vector<ShownSurface> shownSurfaces(const PreparedVolume& volume, const scene::Scene& resolved,
                                        base::Progress& progress) {
  std::vector<double> values;
  if (resolved.isosurface.opacity > 0.0) values.push_back(resolved.isosurface.value.value());
  for (const scene::ExtraIsosurface& extra : resolved.extraIsosurfaces)
    if (extra.shown && extra.opacity > 0.0) values.push_back(extra.value.value());
  std::vector<ShownSurface> surfaces;
  surfaces.reserve(values.size());
  for (const double value : values)
    surfaces.push_back(
        {value, volume.pieces->hidden(resolved.pieces, value, resolved.isosurface.inside, progress)});
  return surfaces;
}

}  // namespace isolux::volume
