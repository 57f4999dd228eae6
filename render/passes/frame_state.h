// What the passes of one frame share. The renderer owns it; passes keep only what is theirs between frames.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gi/picture_light.h"
#include "gi/seen_points.h"
#include "render/gl/image_pool.h"
#include "render/graph/frame.h"
#include "render/graph/pass.h"
#include "render/passes/processor.h"
#include "render/passes/view_uniforms.h"
#include "render/volume/gpu_volume.h"
#include "render/volume/ray_starts.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/scene.h"
#include "volume/clip/cut_faces.h"
#include "volume/color/second_volume.h"
#include "volume/edge/edge_walk.h"
#include "volume/pieces/piece_sets.h"
#include "volume/statistics/curvature_statistics.h"
#include "volume/statistics/grey_window.h"

namespace isolux::render {

inline constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};  // to clear images with

// An isosurface that is drawn.
struct Surface {
  double value;  // data units
  glm::dvec3 albedo;
  double opacity;
  double facingOpacity = 1.0;  // scene/opacity.h
  bool clipped = true;         // by scene::Clip
  bool opaque() const { return scene::isOpaque(*this); }
};
// The first and those further ones that are shown, without those of opacity 0: none to four.
std::vector<Surface> surfacesOf(const scene::Scene& scene);

// What the edge of the object is looked for in: the trilinear field has no second derivatives.
FieldAt edgeFieldOf(const scene::Scene& scene);

class FrameLight;
struct CutFaceColors;

// The cut faces that rays meet (render/passes/cut_faces_pass.h), bottom row first.
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
  std::vector<volume::HiddenOfSurface> hidden;         // of them; none where all pieces are shown
  volume::SurfaceCut cut;                              // of them
  std::optional<CutFaceImage> cutFaces;                // of the cut faces pass
  std::unique_ptr<CutFaceColors> cutFaceColors;        // null: no cut face is shown
  Texture cutColors;                                   // of them
  const volume::PreparedVolume* prepared = nullptr;    // during render() only; null: nothing is loaded
  std::optional<GpuVolume> volume;                     // none: nothing is loaded
  std::shared_ptr<const volume::SecondVolume> second;  // that colours the surface; null: none
  std::shared_ptr<const volume::PieceSets> pieces;     // of the volume
  glm::dvec2 secondRange{0.0, 1.0};                    // of its values where automatic: of the ranges pass
  std::shared_ptr<const gi::PictureLight> light;       // null: nobody has said what it is
  bool readsLight = false;                 // something in this frame reads light of the surface points
  std::unique_ptr<FrameLight> lighting;    // what passes and the renderer know of it, on the GPU
  volume::CurvatureStatistics statistics;  // of the ranges pass
  ImagePool images;
  OnProcessor onProcessor;                 // instead of shaders
  std::map<std::string, HostImages> host;  // of the crossings that the processor found, by their layer
  std::optional<RayStarts> starts;         // of the rays that shaders cast: the segments pass
  std::vector<Pass*> used;  // the passes that this frame needs, drawn anew or not, in their order

  // Rays in bricks (render/volume/brick_rounds.h). onlyWaiting: the cast is of the rays that waited for a
  // brick. keepHits: nothing of the hits is cleared, because what cannot be drawn anew stays.
  bool onlyWaiting = false, keepHits = false;
  std::optional<volume::Rectangle> raysOfRound;  // all that is drawn; none: everything

  // The crossing that is drawn now: "" the first, otherwise one behind (layers pass), and the one before it.
  std::string layer, layerBefore;
  bool anyBehind = false;     // the cast of the layer found a crossing
  gi::SeenPoints hitsBehind;  // of the layers, where the look reads stored light

  // What is drawn: the picture, or a tile of it.
  glm::ivec2 drawnSize() const { return request.tile ? request.tile->size : request.size; }
  glm::ivec2 tileOrigin() const { return request.tile ? request.tile->origin : glm::ivec2(0); }
  glm::ivec2 raySize() const { return drawnSize() * request.supersampling; }
  volume::PictureRays rays() const {
    return view->rays(request.size * request.supersampling, tileOrigin() * request.supersampling);
  }
  // Rays per pixel that settings mean: widths and lengths given in pixels are this many rays.
  double raysPerWidth() const { return request.supersampling * request.pixelRatio; }
  // Null: rays of this frame meet no bricks.
  Bricks* bricks() { return volume && !onProcessor.all ? volume->bricks() : nullptr; }
  bool crossed = true;  // VolumeState::crossed
  bool empty() const {
    return !volume || !crossed || volume->activeBlocks() == 0;
  }  // no ray can hit anything
  double outward() const {
    return scene->isosurface.inside == scene::Inside::above ? -1.0 : 1.0;
  }  // times gradient

  // Images at the size of the rays (render/graph/pass.h, image::): to draw into, and to read from.
  Target& target(const std::string& name, const std::vector<GLenum>& formats) {
    return images.make(gl, name + layer, raySize(), formats);
  }
  const Texture& image(const std::string& name, std::size_t which = 0) const {
    return images.at(name + layer).images[which];
  }
  // Where the crossing may be seen: rays beyond do not have it.
  const volume::PictureArea& area() const { return images.at(image::surface + layer).drawn; }

  bool seesCutFaces() const { return cutFaceColors && cutFaces && !cutFaces->area.empty(); }
  // A bit for each surface that is cut.
  int clippedBits() const;
  // What is drawn of the surface and of cut faces, in pixels of the picture or tile.
  std::vector<volume::Rectangle> surfacePixels() const;
  std::optional<Tile> legend;  // where it stands in the whole picture; kept with image::picture

  // What is drawn in this frame: gradients, of normals; Hessians, with the gradients beside them; and whether
  // those are the gradients of normals, too.
  bool withGradient = false, withHessian = false, gradientShared = false;
  const Texture& gradientImage() const { return image(gradientShared ? image::hessian : image::gradient); }
  // What second derivatives are of.
  FieldAt curvatureField() const { return {scene->derivatives.field, scene::derivativesScale(*scene)}; }
  FieldAt edgeField() const { return edgeFieldOf(*scene); }
  volume::EdgeSearch<double> edgeSearch() const;

  // A pass over the picture: its program (made once for each set of defines; BRICKS is one where the volume
  // is in bricks), its target, and a triangle over all of it, or over rectangles.
  Program& program(const std::string& fragment, const std::string& defines = "");
  void begin(const Target& target) const;
  void begin(const Target& target, glm::ivec2 size) const;
  // Once the request is stopped the rest stays undrawn: software rasterisers draw in bands of a few
  // milliseconds, because a draw call that was begun cannot be left.
  void drawFullscreen(const Program& program) const;
  void drawRectangles(const Program& program, const std::vector<volume::Rectangle>& rectangles) const;
  void drawStarts(const Program& program) const;  // only where rays can meet anything: a program with TILES
  // Fills each of the images with its value.
  void clear(Target& target, std::initializer_list<const float*> values) const;
  void copy(const Target& from, Target& to) const;  // their first images
  // Draws what `program` says of area(), or another area, beyond which it would write what stands for
  // nothing: there the target is left as it is, or drawn over where it shows what was in another area.
  void drawHits(Target& target, const Program& program) const { drawHits(target, program, area()); }
  void drawHits(Target& target, const Program& program, const volume::PictureArea& of) const;
  void setView(Program& program) const;  // the uniforms of common.glsl
  // The uniforms of surface.glsl: surface points, gradients (where there are any) and what is known of the
  // hit, in units `unit` to unit + 2.
  void setPoint(Program& program, int unit) const;
  glm::dvec3 towardLight() const;  // unit, world
  double flatCurvature() const;    // below which a surface counts as flat, 1/mm: volume/field/curvature.h
  bool drawsAny(const std::function<void()>& draw);           // whether any sample passed
  std::int64_t samplesOf(const std::function<void()>& draw);  // how many passed; colours are left as they are
  // uIsovalues and uIsovalueShifts, as texels of what `field` is made from.
  void setIsovalues(Program& program, scene::Field field) const;

 private:
  using Parts = std::vector<volume::Rectangle>;
  void drawParts(const Parts& parts, const std::function<void()>& draw) const;
  void drawInBands(const Parts& parts, const std::function<void()>& draw) const;
  void drawPart(const volume::Rectangle& part, const std::function<void()>& draw) const;

  mutable glm::ivec2 drawing_{0};  // pixels of what begin() was told of
  VertexArray emptyArray_;
  Query anySamples_, samples_;
  std::map<std::string, Program> programs_;
};

}  // namespace isolux::render
