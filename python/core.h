// A volume as Python holds it: voxels and all that was made of them, and, on its desk's thread, the graphics
// context, the renderer and the stored light that its pictures share.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include "app/accuracy/accuracy.h"
#include "app/accuracy/error_images.h"
#include "app/light/light_controller.h"
#include "app/options/scene_options.h"
#include "python/volume_thread.h"
#include "render/offscreen_renderer.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::python {

struct PictureRequest {
  app::SceneOptions scene;
  std::optional<glm::ivec2> size;
  std::string images;  // of --aov; empty: none
  bool color = true, linear = false, explain = false, accuracy = false, lightAround = false;
  std::string light;  // a file of `isolux bake`
  render::ContextChoice context = render::ContextChoice::automatic;
};

struct Picture {
  glm::ivec2 size{0};
  render::ColorImage color;  // empty unless asked for
  std::optional<render::LinearImage> linear;
  std::vector<render::AovImage> images;
  std::vector<app::FloatChannel> errors;
  std::vector<app::FloatChannel> exr;  // all images and errors, where errors were asked for
  std::string opened;                  // what the volume was opened from; empty: an array
  scene::Scene scene;                  // app::carriedScene()
  std::optional<app::Accuracy> accuracy;
  std::string stats;  // JSON
  std::vector<std::string> notes;
};

struct Baked {
  std::string stats;               // JSON
  std::vector<std::string> notes;  // one line each
};

// Work on the desk keeps the volume: an interrupted caller may be gone before it ends.
class Core : public std::enable_shared_from_this<Core> {
 public:
  // Reads `path`, which may be a session; `assignments` are of the source.
  static std::shared_ptr<Core> open(const std::string& path, const app::SceneOptions& options,
                                    const pybind11::object& told);
  // `array`: C-ordered (z, y, x) of a type of VoxelType. `directions`: columns are the voxel axes x, y, z.
  // Throws Error{usage, memory}.
  static std::shared_ptr<Core> ofArray(const pybind11::array& array, glm::dvec3 spacingMm,
                                       glm::dvec3 originMm, glm::dmat3 directions, const std::string& name,
                                       const std::string& unit, bool anatomical,
                                       const pybind11::object& told);

  std::shared_ptr<const Picture> render(const PictureRequest& request, const pybind11::object& told);
  // Runs question(scene, progress) on the desk, with the complete scene, and returns what that returns.
  template <class Question>
  auto ask(const app::SceneOptions& options, Question question, const pybind11::object& told) {
    return desk_.answer(
        [self = shared_from_this(), options, question = std::move(question)](base::Progress& progress) {
          return question(self->completeScene(options, progress), progress);
        },
        told);
  }
  // Writes all light of the scene to a .vti, as `isolux bake` does; stats are what --stats says of it.
  Baked bake(const app::SceneOptions& options, const std::string& file, bool overwrite, bool mixArithmetic,
             const pybind11::object& told);
  // Returns study.json.
  std::string study(const app::SceneOptions& options, const std::string& qualities, glm::ivec2 size,
                    int repeat, const pybind11::object& told);
  void forgetLight(const pybind11::object& told);

  const std::shared_ptr<const volume::PreparedVolume>& prepared() const { return prepared_; }
  const std::string& path() const { return path_; }  // "" of an array

 private:
  struct Graphics;  // lives on the desk's thread
  Core();
  scene::Scene sceneOf(const app::SceneOptions& options) const;
  scene::Scene completeScene(const app::SceneOptions& options, base::Progress& progress) const;
  Graphics& graphics(render::ContextChoice choice);
  std::shared_ptr<Picture> draw(const PictureRequest& request, base::Progress& progress);

  std::string path_;
  scene::Source source_;  // as it was read
  std::shared_ptr<const volume::PreparedVolume> prepared_;
  std::shared_ptr<std::unique_ptr<Graphics>> graphics_;
  VolumeThread desk_;
};

}  // namespace isolux::python
