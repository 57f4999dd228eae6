// Defines a pass of the renderer: name, shader, the images it reads and writes, the settings that its result
// depends on, and its execution. render/passes/pass_declarations.cpp lists the passes in their order.
//
// A pass depends on a set of paths of scene/settings/settings.h; a value counts only if the setting is active
// (scene/rules/relevance.h). Passes also depend on inputs that are not settings (the volume, the image size).
// They may depend on numbers derived from settings (the phase of a flow), too.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "render/graph/frame_graph.h"
#include "scene/scene.h"
#include "scene/settings/scene_list.h"

namespace isolux::render {

struct FrameState;

// States which passes of a frame run on the CPU instead of in shaders (render/passes/processor.h).
struct OnProcessor {
  bool casts = false;
  // Derivatives and shadows too: no pass of the frame reads voxels or blocks on the GPU, and nothing of the
  // volume is uploaded.
  bool all = false;
};

struct Pass;
using PassList = std::vector<Pass>;

// Names of passes used outside the pass's own file.
namespace pass {
inline constexpr const char *bricks = "bricks", *cast = "cast", *refine = "refine", *merge = "merge",
                            *gradient = "gradient", *hessian = "hessian", *irradiance = "irradiance",
                            *layers = "layers", *openness = "openness", *reflections = "reflections",
                            *shadow = "shadow", *shade = "shade", *resolve = "resolve";
}

// Names of the images that passes write. Images that are drawn are stored under these names
// (render/gl/image_pool.h).
namespace image {
inline constexpr const char *activeBlocks = "active blocks", *segments = "ray segments",
                            *bricks = "resident bricks", *bracket = "brackets", *surface = "surface points",
                            *gradient = "gradients", *hessian = "Hessians", *tangents = "tangent planes",
                            *curvature = "curvatures", *edge = "edges",
                            *second = "values of the second volume", *piece = "pieces", *label = "labels",
                            *ranges = "curvature ranges", *shadow = "shadows", *openness = "openness",
                            *occlusion = "occlusions", *flowField = "flow fields", *flow = "streaks",
                            *extrema = "curvature extrema", *lineField = "line fields", *lines = "lines",
                            *light = "stored light", *cutFaces = "cut faces", *irradiance = "irradiances",
                            *reflections = "reflections", *front = "front colour", *color = "colour",
                            *background = "background", *picture = "picture",
                            *linear = "linear picture";  // the image before it is encoded
}

// The volume, as far as passes depend on it. If the GPU's copy of the same voxels is made again, images stay
// valid. Data in that copy (active blocks, resident bricks) do not, so their passes depend on `made`, too.
struct VolumeState {
  VolumeState(std::uint64_t hashOfVoxels = 0, std::uint64_t copiesMade = 0)  // NOLINT: a hash is a volume
      : hash(hashOfVoxels), made(copiesMade) {}
  std::uint64_t hash;           // of the voxels and their position; 0: none
  std::uint64_t made;           // differs between any two GpuVolumes of one renderer
  std::uint64_t second = 0;     // hash of the volume that colours the surface; 0: none
  bool crossed = true;          // false: no cell contains a shown isovalue
  std::uint64_t hidden = 0;     // volume::keyOf() of hidden components; 0: all are shown
  bool hasLabels = false;       // its surfaces are of labels
  std::size_t labelFields = 0;  // surfaces of labels that have a field each; 0: all are of the volume
};

// The bricks of a volume, as far as passes depend on them.
struct BrickState {
  bool inUse = false;
  // Not all bricks fit: those at the hits may be evicted before they are needed again.
  bool mayReplace = false;
  std::uint64_t made = 0;   // number of times the cache was created
  std::uint64_t asked = 0;  // changes when rays request bricks that the next frame can load
};

// The light of a frame (gi::PictureLight), as far as passes depend on it.
struct LightState {
  bool stored = false;        // there is a lattice, and the frame reads it
  std::uint64_t storage = 0;  // changes with the lattices stored and with their contents
  bool inner = false;         // it has light of back faces
  std::uint64_t skyRevision = 0, lampsRevision = 0;  // of the lattices
  std::uint64_t innerSkyRevision = 0, innerLampsRevision = 0;
  std::uint64_t unfinished = 0;    // changes with each frame that has left uploads pending
  std::uint64_t version = 0;       // of all but the lattices; 0: the light is unknown
  float automaticExposure = 0.0f;  // stops
  bool background = false;         // the environment is shown as the background
  bool gloss = false;              // it knows what glossy surfaces reflect
  std::uint64_t ground = 0;        // changes with the shadow on the ground; 0: there is no ground
};

// All inputs that determine which passes a frame needs and their dependencies.
class Asked {
 public:
  Asked(const scene::Scene& scene, const FrameRequest& request, const VolumeState& volume,
        const BrickState& bricks, const LightState& light, const OnProcessor& onProcessor = {});

  const scene::Scene& scene;  // resolved
  const FrameRequest& request;
  const VolumeState volume;
  const BrickState bricks;
  const LightState light;
  const OnProcessor onProcessor;

  // Returns how many groups of surfaces are cast one after another: at least one.
  std::size_t groups() const;
  // Returns whether the setting can change the requested image or AOVs.
  bool acts(std::string_view path) const;
  // Returns the hash of the setting's value; one and the same for all values of an inactive setting.
  std::uint64_t hashOf(const scene::Setting& setting) const;
  // Returns the hash of a field of all items of a list, without ids; inactive settings are left out.
  std::uint64_t hashOf(const scene::SceneList& list, std::size_t field) const;

 private:
  // AOVs read derivatives and light whatever the look: settings are active if they are under a look that
  // reads both.
  std::optional<scene::Scene> ofImages_;
  mutable std::unordered_map<const scene::Setting*, std::uint64_t> hashes_;
  mutable std::unordered_map<const scene::SettingInfo*, std::uint64_t> itemHashes_;
};

// Builds the declaration of a pass for one frame.
class Declaring {
 public:
  Declaring(const Asked& of, const PassList& list, const std::vector<PassDeclaration>& before,
            std::string_view name)
      : asked(of), passes(list), earlier(before) {
    declared.name = name;
  }

  const Asked& asked;
  const PassList& passes;
  const std::vector<PassDeclaration>& earlier;  // of the preceding passes in the list
  PassDeclaration declared;

  Declaring& reads(std::string_view image);
  // `bytesPerRay`: of images at the size of the rays.
  Declaring& writes(std::string_view image, int bytesPerRay = 0);
  // Gives the image that was declared last another name.
  Declaring& writesAs(const char* otherName) { return writes(otherName, PassDeclaration::kSameImage); }
  // Declares that the result depends on these settings (patterns of scene::covers()), but not on those in
  // `except`.
  Declaring& settings(std::initializer_list<std::string_view> paths,
                      std::initializer_list<std::string_view> except = {});
  // Declares that it also depends on what holds of each shown surface.
  Declaring& ofSurfaces(const char* name, bool (*holds)(const scene::Surface&));
  // Declares that it also depends on these values, which are not settings or come from several.
  template <class... Values>
  Declaring& input(const char* name, const Values&... values) {
    base::Hasher hash;
    (hash.add(values), ...);
    return add({name, hash});
  }
  Declaring& add(const Parameter& parameter);  // asserts that inputs of one name are equal
  // States why the pass does not run in such a scene: no pass reads its images.
  Declaring& notNeeded(const char* why);

  // Declare inputs of several passes.
  Declaring& volume();       // the voxels and their position
  Declaring& pictureSize();  // rays, and the part of the image that is drawn
  Declaring& isovalues();    // the shown surfaces and their hidden components
  Declaring& cuts();         // the clipping of the surfaces
  Declaring& second();       // the volume that colours the surface, and how it is looked up
};

// An image of a pass that the look reads (resources/shaders/look/shade.frag.glsl).
struct LookInput {
  const char* image = "";
  const char* define = "";                              // set if the look reads it
  std::vector<const char*> samplers = {};               // of the image's textures, in order
  bool (*isRead)(const scene::Scene& scene) = nullptr;  // null: never
};

struct Pass {
  std::string_view name;           // compared as text: equal literals may have different addresses
  void (*declare)(Declaring& d);   // declares the pass for a frame; pure, and without GL
  void (*run)(FrameState& frame);  // draws the declared images, for the frame's current crossing
  LookInput lookInput{};
  struct Kind {
    bool castsRays = false;   // in bricks, rays may reach some that are not resident: drawn in rounds
    bool atHits = false;      // reads voxels at the hits: in bricks, drawn before those are replaced
    bool ofCrossing = false;  // drawn again for each crossing behind a transparent surface
  } kind{};
  enum class Cpu { never, casts, all, always };       // casts, all: as OnProcessor says
  Cpu cpu = Cpu::never;                               // whether the CPU computes it
  std::size_t (*bytes)(const FrameState&) = nullptr;  // that it writes outside the image pool; null: none

  bool isReadByLook(const scene::Scene& scene) const { return lookInput.isRead && lookInput.isRead(scene); }
  bool isOn(const OnProcessor& on) const {
    return cpu == Cpu::always || (cpu == Cpu::casts && on.casts) || (cpu == Cpu::all && on.all);
  }
};

}  // namespace isolux::render
