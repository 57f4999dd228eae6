// A pass of the renderer is one object: its name, its shader, the images it reads and writes, the settings
// that its result depends on, and how it runs. render/passes/pass_list.cpp lists them in their order.
//
// What a pass depends on is a set of paths of scene/settings.h; their values are read through that list, and
// count only where the setting acts (scene/rules/relevance.h). Beside them stand inputs that are no settings
// (the volume, the size of the picture), or numbers through which alone a setting acts (which surfaces are
// there, where the pattern of a flow stands).
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/hash.h"
#include "render/graph/frame_graph.h"
#include "scene/scene.h"
#include "scene/settings.h"

namespace isolux::render {

struct FrameState;

// Which passes of a frame the processor computes instead of shaders (render/passes/processor.h).
struct OnProcessor {
  bool casts = false;
  // Derivatives and shadows too: no pass of the frame reads voxels or blocks on the graphics card, and
  // nothing of the volume is uploaded.
  bool all = false;
};

class Pass;
using PassList = std::vector<std::unique_ptr<Pass>>;

// The names that are spoken of outside the pass's own file.
namespace pass {
inline constexpr const char *bricks = "bricks", *cast = "cast", *refine = "refine", *gradient = "gradient",
                            *hessian = "hessian", *irradiance = "irradiance", *layers = "layers";
}

// What passes write. Those that are drawn are kept under these names (render/gl/image_pool.h).
namespace image {
inline constexpr const char *activeBlocks = "active blocks", *segments = "ray segments",
                            *bricks = "resident bricks", *bracket = "brackets", *surface = "surface points",
                            *gradient = "gradients", *hessian = "Hessians", *curvature = "curvatures",
                            *edge = "edges", *second = "values of the second volume", *piece = "pieces",
                            *ranges = "curvature ranges", *shadow = "shadows", *openness = "openness",
                            *occlusion = "occlusions", *flowField = "flow fields", *flow = "streaks",
                            *extrema = "curvature extrema", *lineField = "line fields", *lines = "lines",
                            *light = "stored light", *cutFaces = "cut faces", *irradiance = "irradiances",
                            *front = "front colour", *color = "colour", *background = "background",
                            *picture = "picture",
                            *linear = "linear picture";  // the picture before it is encoded
}

// The volume, as far as passes depend on it. Images that show the same voxels stay good when the GPU's copy
// of them is made anew; what lives in that copy (active blocks, resident bricks) does not: its passes depend
// on `made` too.
struct VolumeState {
  VolumeState(std::uint64_t hashOfVoxels = 0, std::uint64_t copiesMade = 0)  // NOLINT: a hash is a volume
      : hash(hashOfVoxels), made(copiesMade) {}
  std::uint64_t hash;        // of the voxels and where they lie; 0: none
  std::uint64_t made;        // differs between any two GpuVolumes of one renderer
  std::uint64_t second = 0;  // hash of the volume that colours the surface; 0: none
  bool crossed = true;       // false: no cell holds a value of a surface that is shown
  std::uint64_t hidden = 0;  // volume::keyOf() of pieces that are not shown; 0: all are
};

// A volume in bricks, as far as passes depend on it.
struct BrickState {
  bool inUse = false;
  bool mayReplace = false;  // not all bricks fit: those at the hits may be gone when they are wanted again
  std::uint64_t made = 0;   // how often the cache was made
  std::uint64_t asked = 0;  // changes when rays ask for bricks that the next frame can give
};

// The light of a picture (gi::PictureLight), as far as passes depend on it.
struct LightState {
  bool stored = false;        // there is a lattice, and the frame reads it
  std::uint64_t storage = 0;  // changes when other lattices, or other contents of them, are held
  bool inner = false;         // it has light of inner sides
  std::uint64_t skyRevision = 0, lampsRevision = 0;  // of the lattices
  std::uint64_t innerSkyRevision = 0, innerLampsRevision = 0;
  std::uint64_t unfinished = 0;    // changes with each frame that has left uploads over
  std::uint64_t version = 0;       // of all but the lattices; 0: nobody has said what it is
  float automaticExposure = 0.0f;  // stops
  bool background = false;         // the environment is there to be seen
};

// All that decides which passes a frame needs and what they depend on.
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

  // Whether the setting can change what is asked for: the picture or a deferred image.
  bool acts(std::string_view path) const;
  // Of its value; one and the same hash for all values of a setting that does not act.
  std::uint64_t hashOf(const scene::Setting& setting) const;

 private:
  // Deferred images read derivatives and light whatever the look: settings act where they act under a look
  // that reads both.
  std::optional<scene::Scene> ofImages_;
  mutable std::unordered_map<const scene::Setting*, std::uint64_t> hashes_;
};

// What a pass says of itself for one frame.
class Declaring {
 public:
  Declaring(const Asked& of, const PassList& list, const std::vector<PassDeclaration>& before,
            std::string_view name)
      : asked(of), passes(list), earlier(before) {
    declared.name = name;
  }

  const Asked& asked;
  const PassList& passes;
  const std::vector<PassDeclaration>& earlier;  // of the passes before it in the list
  PassDeclaration declared;

  Declaring& reads(const char* image);
  Declaring& writes(const char* image);
  // The result depends on these settings (patterns of scene::covers()), but not on those in `except`.
  Declaring& settings(std::initializer_list<std::string_view> paths,
                      std::initializer_list<std::string_view> except = {});
  // It depends on these values, too, which are no settings or come from several.
  template <class... Values>
  Declaring& input(const char* name, const Values&... values) {
    base::Hasher hash;
    (hash.add(values), ...);
    return add({name, hash});
  }
  Declaring& add(const Parameter& parameter);  // once for each name
  // Why it does not run in such a scene: nobody reads what it writes.
  Declaring& notNeeded(const char* why);

  // Inputs of several passes.
  Declaring& volume();       // the voxels and where they lie
  Declaring& pictureSize();  // rays, and the part of the picture that is drawn
  Declaring& isovalues();    // the surfaces that are there, and what of them is hidden
  Declaring& cuts();         // what is cut away of them
  Declaring& second();       // the volume that colours the surface, and what of it is looked up
};

// An image that the look reads (resources/shaders/look/shade.frag.glsl).
struct LookInput {
  const char* image;
  const char* define = "";                 // set where the look reads it
  std::vector<const char*> samplers = {};  // of the image's textures, in their order
};

class Pass {
 public:
  struct Kind {
    bool castsRays = false;   // in bricks, rays meet some that are not resident: drawn in rounds
    bool atHits = false;      // reads voxels at the hits: in bricks, drawn before those are replaced
    bool ofCrossing = false;  // drawn again for each crossing behind a transparent surface
  };
  Pass(const char* itsName, const char* itsShader, const Kind& itsKind)
      : name(itsName), shader(itsShader), kind(itsKind) {}
  virtual ~Pass() = default;
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  const std::string_view name;  // compared as text: equal literals need not lie at one place
  const char* const shader;     // the fragment shader; "": it draws nothing
  const Kind kind;

  // Pure, and without GL.
  virtual void declare(Declaring& d) const = 0;
  // What the look of this scene reads of it.
  virtual std::optional<LookInput> forLook(const scene::Scene&) const { return std::nullopt; }

  // From here on with GL. Draws what was declared, of the crossing that the frame is at.
  virtual void run(FrameState& frame) = 0;
  // Memory of what it writes, where that is no image of the pool.
  virtual std::optional<std::size_t> bytes(const FrameState&) const { return std::nullopt; }
  // Whether it is one of those that the processor computes.
  virtual bool isOn(const OnProcessor&) const { return false; }
  // Drops what it keeps between frames because it could be needed again.
  virtual void forget() {}
};

}  // namespace isolux::render
