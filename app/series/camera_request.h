// A camera said in words: by name, turned, framed, nearer. It needs the volume, whose axes, box and surface
// decide.
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

enum class Framing { surface, volume };

struct CameraRequest {
  std::string view;                       // scene::standardViewNamed(); empty: the scene's camera
  double azimuth = 0.0, elevation = 0.0;  // degrees, scene::turned()
  double roll = 0.0;                      // degrees, scene::rolled(): the picture turns clockwise
  double zoom = 1.0;                      // > 1: nearer
  std::optional<Framing> fit = std::nullopt;

  bool any() const {
    return !view.empty() || azimuth != 0.0 || elevation != 0.0 || roll != 0.0 || zoom != 1.0 || fit;
  }
};

// The view, turned, then framed in what a picture of this size has free (freeRooms()), then zoomed.
// overlayLegend: as there. Where the request does not
// say what is framed, a camera that was automatic frames what its camera.frames says, and a view by name of
// another the volume's box; a surface that is not there leaves the camera where it is. Throws base::Error:
// usage for a view of no such name; interrupted, memory.
scene::Camera requestedCamera(const CameraRequest& request, const scene::Scene& scene,
                              const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress,
                              glm::ivec2 overlayLegend = glm::ivec2(0));

// The camera that a turntable starts from: its target stands still and what is framed stays in the picture
// all the way round. Without a request for it, of a camera that was automatic the surface is framed, another
// stays where it is.
scene::Camera turntableStart(const CameraRequest& request, bool automatic, const scene::Scene& resolved,
                             const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress);
// Of so many views, the one by this index: turned counterclockwise about the volume's up, as seen from above.
scene::Camera turntableCamera(const scene::Camera& start, scene::WorldAxes axes, int index, int count);

}  // namespace isolux::app
