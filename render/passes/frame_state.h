// Holds the data that the passes of one frame share. The renderer owns it; passes keep only their own data
// between frames.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gi/picture_light.h"
#include "gi/visible_point_set.h"
#include "render/gl/image_pool.h"
#include "render/gl/part_timer.h"
#include "render/graph/frame.h"
#include "render/graph/pass.h"
#include "render/passes/processor.h"
#include "render/passes/view_uniforms.h"
#include "render/volume/gpu_volume.h"
#include "render/volume/ray_starts.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/scene.h"
#include "volume/cast/hit_info.h"
#include "volume/clip/cut_faces.h"
#include "volume/color/second_volume.h"
#include "volume/edge/edge_walk.h"
#include "volume/statistics/curvature_statistics.h"
#include "volume/statistics/grey_window.h"

namespace isolux::render {

inline constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};  // to clear images

// An isosurface that is drawn.
struct Surface {
  double value;  // data units
  glm::dvec3 albedo;
  double opacity;
  double facingOpacity = 1.0;              // scene/opacity.h
  bool clipped = true;                     // by scene::Clip
  double specular = 0.0, roughness = 1.0;  // gi/sampling/gloss_lobe.h
  bool labelColors = true;                 // instead of the albedo, of a surface of labels
  bool opaque() const { return scene::isOpaque(*this); }
};
// Returns the first isosurface and the shown further ones, without those of opacity 0.
std::vector<Surface> surfacesOf(const scene::Scene& scene);

std::vector<double> valuesOf(std::span<const Surface> surfaces);

// One cast follows a group of up to so many isosurfaces of one volume, in their order. Surfaces of labels
// that have a field each are a group each.
inline constexpr std::size_t kGroupSurfaces = volume::HitInfo::kSurfaces;
// Returns the length of arrays with a number for each of so many surfaces: a multiple of kGroupSurfaces.
std::size_t placesOf(std::size_t surfaces);
// Returns the name of what the cast of a group draws: the image's own if there is one group, else the merge
// pass makes the image of it.
std::string ofGroup(const char* image, std::size_t group, std::size_t groups);

// Returns the field in which the object's edge is searched: the trilinear field has no second derivatives.
FieldAt edgeFieldOf(const scene::Scene& scene);

class FrameLight;
struct CutFaceColors;
struct LookTextures;

// The caps that rays meet (render/passes/cut_faces_pass.h), bottom row first.
struct CutFaceImage {
  explicit CutFaceImage(glm::ivec2 size);
  base::MemoryBudget::Held held;
  volume::PictureArea area;
  std::vector<float> ends;        // t, mm; +inf: none
  std::vector<glm::vec2> texels;  // t (-1: none) and value
};

struct FrameState {
  explicit FrameState(GlPtr pointer);
  ~FrameState();

  GlPtr gl;
  const scene::Scene* scene = nullptr;  // resolved; during render() only
  FrameRequest request;
  std::optional<ViewUniforms> view;
  std::vector<Surface> surfaces;
  volume::SurfaceCut cut;                            // of the surfaces
  std::optional<CutFaceImage> cutFaces;              // of the cut faces pass
  std::unique_ptr<CutFaceColors> cutFaceColors;      // null: no cap is shown
  Texture cutColors;                                 // of the caps
  const volume::PreparedVolume* prepared = nullptr;  // during render() only; null: nothing is loaded
  // Hold the surfaces: the volume itself, or of labels a field for each surface. Empty: nothing is loaded.
  std::vector<std::unique_ptr<GpuVolume>> volumes;
  GpuVolume* volume = nullptr;                         // of the group; null: nothing is loaded
  std::shared_ptr<const volume::SecondVolume> second;  // that colours the surface; null: none
  glm::dvec2 secondRange{0.0, 1.0};                    // of its values, if automatic; set by the ranges pass
  std::shared_ptr<const gi::PictureLight> light;       // null: the light is unknown
  bool readsLight = false;                 // a pass of this frame reads light of the surface points
  std::unique_ptr<FrameLight> lighting;    // the light on the GPU
  volume::CurvatureStatistics statistics;  // set by the ranges pass
  ImagePool images;
  std::unique_ptr<LookTextures> lookTextures;  // of the shade pass
  int occlusionCrossing = 0;                   // of the occlusion pass: 0 is the first crossing
  OnProcessor onProcessor;                     // instead of shaders
  std::map<std::string, HostImages> host;      // crossings found on the CPU, by layer
  std::vector<RayStarts> starts;               // of rays that shaders cast, of each volume; by segments
  std::vector<const Pass*> used;               // the passes that this frame needs, run or cached, in order

  // Rays in bricks (render/passes/brick_rounds.h). `onlyWaiting`: the cast is of the rays that waited for a
  // brick. `keepHits`: passes do not clear the images of the hits, because some parts cannot be drawn again.
  bool onlyWaiting = false, keepHits = false;
  std::optional<volume::Rectangle> raysOfRound;  // the only part drawn; nullopt: everything

  // The group that is cast now, and the surfaces in it.
  std::size_t group = 0;
  std::size_t groups() const;
  bool isOfLabels() const { return volumes.size() > 1; }  // each group has a volume of its own
  // Solids of labels that touch have one skin between them.
  bool joinsSolids() const { return isOfLabels() && scene::isTransparent(*scene); }
  void takeGroup(std::size_t which);
  // Returns the place of the group's first surface among all.
  std::size_t firstSurface() const { return group * (isOfLabels() ? 1 : kGroupSurfaces); }
  std::span<const Surface> groupSurfaces() const;
  // Returns the surfaces of the group's volume.
  std::span<const Surface> volumeSurfaces() const { return isOfLabels() ? groupSurfaces() : surfaces; }
  template <class Draw>
  void forGroups(const Draw& draw) {
    for (std::size_t which = 0; which < groups(); ++which) {
      takeGroup(which);
      draw();
    }
    takeGroup(0);
  }
  // The same once for each volume.
  template <class Draw>
  void forVolumes(const Draw& draw) {
    if (isOfLabels()) return forGroups(draw);
    draw();
  }
  const GpuVolume& volumeOf(std::size_t surface) const { return *volumes[isOfLabels() ? surface : 0]; }
  // Return the place of the group's first surface, and the starts of rays, in those of its volume.
  std::size_t placeInVolume() const { return isOfLabels() ? 0 : firstSurface(); }
  RayStarts& rayStarts() { return starts.at(isOfLabels() ? group : 0); }
  const RayStarts& rayStarts() const { return starts.at(isOfLabels() ? group : 0); }
  // Returns the define and sets the uniforms by which a shader leaves out the hits of other volumes.
  std::string volumeDefines() const { return isOfLabels() ? "#define OF_GROUP\n" : ""; }
  void setVolumeHits(Program& program, int unit) const;
  bool isOfVolume(volume::HitInfo info) const {
    return !isOfLabels() || info.surface() == static_cast<int>(firstSurface());
  }
  // Returns the name under which the cast of the group draws an image.
  std::string castName(const char* image) const { return ofGroup(image, group, groups()); }

  // The crossing drawn now ("" the first, otherwise one behind: layers pass), and the one before it.
  std::string layer, layerBefore;
  bool anyBehind = false;                // the layer's cast found a crossing
  gi::VisiblePointSet hitsBehind;        // of the layers, if the look reads baked lighting
  std::vector<glm::vec3> reflectedHits;  // that the first crossing reflects; those of layers are hitsBehind

  // The drawn part: the image, or a tile of it.
  glm::ivec2 drawnSize() const { return request.tile ? request.tile->size : request.size; }
  glm::ivec2 tileOrigin() const { return request.tile ? request.tile->origin : glm::ivec2(0); }
  glm::ivec2 raySize() const { return (hitPart ? hitPart->size : drawnSize()) * request.supersampling; }
  // Returns the first ray of the images within what is drawn, and within the whole image.
  glm::ivec2 raysLow() const { return hitPart ? hitPart->origin * request.supersampling : glm::ivec2(0); }
  glm::ivec2 rayOrigin() const { return tileOrigin() * request.supersampling + raysLow(); }
  volume::PictureRays rays() const { return view->rays(request.size * request.supersampling, rayOrigin()); }
  // The pixels of what is drawn, from its lower left corner, that images at the size of the rays cover; rays
  // elsewhere hit nothing. None: all. Set by the cast of a frame that keeps no images.
  std::optional<Tile> hitPart;
  bool cropsToHits() const {
    return !request.keepImages && !request.beforeTiles && request.aovs.empty() && !cutFaceColors &&
           groups() == 1;
  }
  // Colours are shaded and resolved in bands of so many rows of rays; 0: at once.
  int bandRows = 0;
  int bandRow = 0;  // the first of the current band, in images at the size of the rays
  // The gradients for normals stay in HostImages; openness and shade read them in strips.
  bool gradientInStrips = false;

  // Returns the rays per pixel in settings: widths and lengths in pixels are multiplied by it.
  double raysPerWidth() const { return request.supersampling * request.pixelRatio; }
  // Returns null if the rays of this frame traverse no bricks.
  Bricks* bricks() { return volume && !onProcessor.all ? volume->bricks() : nullptr; }
  bool crossed = true;  // VolumeState::crossed
  // No ray can hit anything, or a surface of the group.
  bool empty() const {
    return !volume || !crossed ||
           std::ranges::all_of(volumes, [](const auto& one) { return one->activeBlocks() == 0; });
  }
  bool groupIsEmpty() const { return empty() || volume->activeBlocks() == 0; }
  double outward() const {
    return scene->isosurface.inside == scene::Inside::above ? -1.0 : 1.0;
  }  // times gradient

  // Images at the size of the rays (render/graph/pass.h, image::), to draw into and to read from.
  Target& target(const std::string& name, const std::vector<GLenum>& formats) {
    return images.make(gl, name + layer, raySize(), formats);
  }
  const Texture& image(const std::string& name, std::size_t which = 0) const {
    return images.at(name + layer).images[which];
  }
  // Returns where the crossing may be visible: rays outside do not have it.
  const volume::PictureArea& area() const { return images.at(image::surface + layer).drawn; }

  bool seesCutFaces() const { return cutFaceColors && cutFaces && !cutFaces->area.empty(); }
  // Return one bit for each surface of the group that is clipped, or opaque.
  int clippedBits() const;
  int opaqueBits() const;
  // Returns the drawn area of the surface and of caps, in pixels of the image or tile.
  std::vector<volume::Rectangle> surfacePixels() const;
  std::optional<Tile> legend;  // its place in the whole image; kept with image::picture

  // State whether this frame draws Hessians (with their own gradients), and whether these are also the
  // gradients for normals.
  bool withHessian = false, gradientShared = false;
  const Texture& gradientImage() const { return image(gradientShared ? image::tangents : image::gradient); }
  // Returns the field of second derivatives.
  FieldAt curvatureField() const { return {scene->derivatives.field, scene::derivativesScale(*scene)}; }
  FieldAt edgeField() const { return edgeFieldOf(*scene); }
  volume::EdgeSearch<double> edgeSearch() const;

  // Returns the program of a full-screen pass, compiled once for each set of defines; BRICKS is one of them
  // if the volume is in bricks. The draw functions cover all of its target, or rectangles.
  Program& program(const std::string& fragment, const std::string& defines = "");
  void begin(const Target& target) const;
  void begin(const Target& target, glm::ivec2 size) const;
  // After a stop request, the rest stays undrawn. Draws are cut, because a draw call cannot be interrupted:
  // on a software rasteriser into bands of a few milliseconds, on a graphics card into parts of at most about
  // 10 ms (render/gl/draw_parts.h).
  void drawFullscreen(const Program& program) const;
  void drawRectangles(const Program& program, const std::vector<volume::Rectangle>& rectangles) const;
  // Draws only where rays can meet anything. Requires a program with TILES.
  void drawStarts(const Program& program) const;
  // Fills each of the images with its value; those after the last one with that, too.
  void clear(Target& target, std::initializer_list<const float*> values) const;
  // The same, and returns true, if there is nothing to draw.
  bool clearIfEmpty(Target& target, std::initializer_list<const float*> values) const {
    if (empty()) clear(target, values);
    return empty();
  }
  void copy(const Target& from, Target& to) const;  // copies the first image
  // Draws `program` in area(), or another area, outside which it would write the value for nothing. Outside,
  // the target is left unchanged, or drawn over where it shows another area.
  void drawHits(Target& target, const Program& program) const { drawHits(target, program, area()); }
  void drawHits(Target& target, const Program& program, const volume::PictureArea& of) const;
  void setView(Program& program) const;  // sets the uniforms of common.glsl
  // Sets the uniforms of surface.glsl: surface points, gradients (if any) and data of the hit, on the units
  // `unit` to `unit` + 2.
  void setPoint(Program& program, int unit) const;
  glm::dvec3 towardLight() const;  // unit, world
  // Returns the curvature below which a surface counts as flat, 1/mm: volume/field/curvature.h.
  double flatCurvature() const;
  bool drawsAny(const std::function<void()>& draw);  // returns whether any sample passed
  // Returns how many passed; colours are unchanged.
  std::int64_t samplesOf(const std::function<void()>& draw);
  // Returns a number of each surface of the group, of(surface), and 0 behind the last.
  template <class Of>
  glm::vec4 ofGroupSurfaces(const Of& of) const {
    glm::vec4 numbers(0.0f);
    for (int i = 0; const Surface& surface : groupSurfaces()) numbers[i++] = static_cast<float>(of(surface));
    return numbers;
  }
  // Sets an array of hit_info.glsl's length to of(surface) of each surface, and to `others` behind the last.
  template <class Of>
  void setOfSurfaces(Program& program, const char* name, const Of& of, float others = 0.0f) const {
    std::vector<float> numbers(placesOf(surfaces.size()), others);
    std::ranges::transform(surfaces, numbers.begin(),
                           [&](const Surface& surface) { return static_cast<float>(of(surface)); });
    program.set(name, numbers);
  }
  // Returns the defines of hit_info.glsl: none where there is one group.
  std::string surfaceDefines() const;
  // Sets uIsovalues and uIsovalueShifts of the group, as texels of the texture that `field` is made from.
  void setIsovalues(Program& program, scene::Field field) const;

 private:
  using Parts = std::vector<volume::Rectangle>;
  void drawParts(const Program& program, const Parts& parts, const std::function<void()>& draw) const;
  void drawTimed(const Program& program, const Parts& parts, const std::function<void()>& draw) const;
  void drawInBands(const Parts& parts, const std::function<void()>& draw) const;
  void drawPart(const volume::Rectangle& part, const std::function<void()>& draw) const;

  mutable glm::ivec2 drawing_{0};  // pixels, set by begin()
  VertexArray emptyArray_;
  Query anySamples_, samples_;
  std::map<std::string, Program> programs_;
  mutable std::map<GLuint, PartTimer> timers_;  // of programs, on a graphics card
};

}  // namespace isolux::render
