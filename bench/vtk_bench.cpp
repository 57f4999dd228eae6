// Isolux against VTK on one GL driver: same volume, isovalue, camera and picture, in turns. Each picture is
// checked against the double-precision intersector first: two programs that draw different things cannot be
// compared.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/quantiles.h"
#include "bench/bench.h"
#include "bench/frame.h"
#include "bench/subjects.h"
#include "bench/vtk_picture.h"
#include "scene/camera.h"
#include "volume/hit/exact_hit.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 5;
constexpr double orbitStep = 0.02;      // radians per frame
constexpr double isovalueStep = 0.005;  // of the value range, there and back

// Depth along the view direction (mm) where there is a surface, NaN elsewhere. Row 0 is the top row.
using DepthPicture = std::vector<double>;

// The first hits of the double-precision intersector, on every fourth pixel of every fourth row.
struct Yardstick {
  static constexpr int stride = 4;
  struct Pixel {
    std::size_t index;
    double depth;        // mm, NaN: no surface
    double voxelsPerMm;  // along the view direction, on this ray
  };
  std::vector<Pixel> pixels;
  double inside = 0.0;  // mm that a ray goes through the volume to its hit or to the end; mean of all pixels

  Yardstick(const volume::PreparedVolume& volume, const scene::Scene& scene) {
    const glm::dmat4 voxelFromWorld = volume.grid().geometry().voxelFromWorld();
    const scene::CameraFrame camera = scene::frameOf(scene.camera);
    for (int y = stride / 2; y < pictureSize.y; y += stride)
      for (int x = stride / 2; x < pictureSize.x; x += stride) {
        const glm::dvec2 ndc((2.0 * x + 1.0) / pictureSize.x - 1.0, 1.0 - (2.0 * y + 1.0) / pictureSize.y);
        const scene::Ray ray = scene::rayThrough(camera, ndc, 1.0);
        const glm::dvec3 origin(voxelFromWorld * glm::dvec4(ray.origin, 1.0)),
            direction(voxelFromWorld * glm::dvec4(ray.direction, 0.0));
        const auto hit = volume::firstHit(volume.grid(), *volume.blocks, scene.surfaces.front().value.value(),
                                          {origin, direction});
        const double along = glm::dot(ray.direction, -camera.back);
        pixels.push_back({static_cast<std::size_t>(y) * pictureSize.x + static_cast<std::size_t>(x),
                          hit ? hit->t * along : std::nan(""), glm::length(direction) / along});
        const glm::dvec3 last(volume.grid().dims() - 1), a = -origin / direction,
                                                         b = (last - origin) / direction;
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        const double begin = std::max({in.x, in.y, in.z, 0.0}), end = std::min({out.x, out.y, out.z});
        inside += std::max((hit ? hit->t : end) - begin, 0.0);
      }
    inside /= static_cast<double>(pixels.size());
  }
};

DepthPicture depthOf(const Frame& frame, const scene::Scene& scene) {
  render::FrameRequest request = frame.request;
  request.aovs = std::vector{render::Aov::position};
  frame.renderer->render(scene, request);
  const render::AovImage image = frame.renderer->readAov(render::Aov::position);
  const scene::CameraFrame camera = scene::frameOf(scene.camera);
  DepthPicture depth(image.values.size() / 3);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const glm::dvec3 point(image.values[3 * i], image.values[3 * i + 1], image.values[3 * i + 2]);
    depth[i] = glm::dot(point - camera.eye, -camera.back);
  }
  return depth;
}

DepthPicture depthOf(VtkPicture& picture) {
  VtkSurface surface = picture.surface();
  for (std::size_t i = 0; i < surface.depth.size(); ++i)
    if (!surface.covered[i]) surface.depth[i] = std::nan("");
  return std::move(surface.depth);
}

// Prints how far a picture is from the yardstick, and whether its silhouette is that of `first`.
void printAgreement(const char* name, const DepthPicture& picture, const DepthPicture& first,
                    const Yardstick& yardstick) {
  std::size_t covered = 0, differing = 0, missed = 0, hits = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    covered += !std::isnan(first[i]);
    differing += std::isnan(first[i]) != std::isnan(picture[i]);
  }
  std::vector<double> errors;
  for (const auto& pixel : yardstick.pixels) {
    const double depth = picture[pixel.index];
    hits += !std::isnan(pixel.depth);
    missed += std::isnan(depth) != std::isnan(pixel.depth);
    if (!std::isnan(depth) && !std::isnan(pixel.depth))
      errors.push_back(std::fabs(depth - pixel.depth) * pixel.voxelsPerMm);
  }
  const auto percentile = [&](double p) {
    return errors.empty() ? std::nan("") : base::lowerQuantile(errors, p);
  };
  const double apart = static_cast<double>(differing) / static_cast<double>(covered);
  std::printf(
      "  %-20s silhouette differs in %.3f %% of the surface's pixels; against double precision %zu of %zu "
      "pixels differ, hits are off by %.4f voxels (median), %.4f (99 %%)\n",
      name, 100.0 * apart, missed, hits, percentile(0.5), percentile(0.99));
  if (apart > 0.02) std::printf("  NOT THE SAME PICTURE: the ratios below say nothing\n");
}

void printRatio(const char* what, double theirs, double ours) {
  std::printf("  %-58s = %6.2f\n", what, theirs / ours);
}

// The pictures of an orbit: each call of `draw` gets the next camera.
std::function<void()> orbiting(const scene::Camera& start, std::function<void(const scene::Camera&)> draw) {
  return [start, draw = std::move(draw), frame = 0]() mutable {
    draw(scene::orbited(start, orbitStep * ++frame, 0.0));
  };
}

// A drag of the isovalue: each call of `draw` gets another.
std::function<void()> dragging(const Subject& subject, std::function<void(double)> draw) {
  const volume::Grid& grid = subject.volume->grid();
  const double step = isovalueStep * (grid.maximum() - grid.minimum());
  return [low = subject.isovalue, step, draw = std::move(draw), odd = false]() mutable {
    odd = !odd;
    draw(odd ? low + step : low);
  };
}

void compare(VtkContext& context, const Subject& subject) {
  scene::Scene wanted;
  wanted.surfaces.front().value = subject.isovalue;
  const scene::Scene scene = scene::resolve(wanted, subject.volume->facts);
  const auto ours = [&] {
    context.makeCurrent();
    return Frame(context.gl(), subject.volume, scene);
  };
  const auto theirs = [&](VtkWay way) { return VtkPicture(way, subject.volume, scene, pictureSize); };
  VtkPicture rays = theirs(VtkWay::gpu_mapper), mesh = theirs(VtkWay::mesh),
             isovalueMesh = theirs(VtkWay::mesh), extraction = theirs(VtkWay::mesh);
  Frame whole = ours(), orbit = ours(), isovalue = ours();

  std::printf("  VTK on %s\n", rays.driver().c_str());
  const Yardstick yardstick(*subject.volume, scene);
  context.makeCurrent();
  const DepthPicture ourDepth = depthOf(whole, scene);
  printAgreement("Isolux", ourDepth, ourDepth, yardstick);
  printAgreement("VTK GPU mapper", depthOf(rays), ourDepth, yardstick);
  printAgreement("VTK mesh", depthOf(mesh), ourDepth, yardstick);
  const glm::dvec3 spacing = subject.volume->grid().geometry().spacingMm();
  std::printf("  samples of the GPU mapper, every half voxel to the first hit: %.0f a pixel on average\n",
              yardstick.inside / (0.5 * std::min({spacing.x, spacing.y, spacing.z})));

  const auto ms = medians({orbiting(scene.camera,
                                    [&](const scene::Camera& camera) {
                                      context.makeCurrent();
                                      whole.scene.camera = camera;
                                      whole();
                                    }),
                           orbiting(scene.camera,
                                    [&](const scene::Camera& camera) {
                                      context.makeCurrent();
                                      orbit.scene.camera = camera;
                                      orbit.changed();
                                    }),
                           orbiting(scene.camera,
                                    [&](const scene::Camera& camera) {
                                      rays.setCamera(camera);
                                      rays.render();
                                    }),
                           orbiting(scene.camera,
                                    [&](const scene::Camera& camera) {
                                      mesh.setCamera(camera);
                                      mesh.render();
                                    }),
                           dragging(subject,
                                    [&](double value) {
                                      context.makeCurrent();
                                      isovalue.scene.surfaces.front().value = value;
                                      isovalue.changed();
                                    }),
                           dragging(subject,
                                    [&](double value) {
                                      isovalueMesh.setIsovalue(value);
                                      isovalueMesh.render();
                                    }),
                           dragging(subject,
                                    [&](double value) {
                                      extraction.setIsovalue(value);
                                      extraction.extract();
                                    })},
                          rounds);
  printComparison(
      {"Isolux, every pass of every frame", "Isolux, orbiting", "VTK GPU isosurface mapper, orbiting",
       "VTK mesh, orbiting", "Isolux, new isovalue to picture", "VTK mesh, new isovalue to picture",
       "  of which flying edges"},
      ms);
  std::printf("  the mesh has %zu triangles\n", mesh.triangles());
  printRatio("VTK GPU isosurface mapper / Isolux, every pass", ms[2], ms[0]);
  printRatio("VTK GPU isosurface mapper / Isolux, orbiting", ms[2], ms[1]);
  printRatio("VTK mesh / Isolux, orbiting", ms[3], ms[1]);
  printRatio("VTK mesh / Isolux, new isovalue to picture", ms[5], ms[4]);
  context.makeCurrent();  // the GL objects of the frames end in it
}

void run() {
  if (const auto obstacle = vtkObstacle()) {
    std::printf(" left out: %s\n", obstacle->c_str());
    return;
  }
  VtkContext context;
  std::printf(" Isolux on %s\n %s\n", context.gl()->string(GL_RENDERER).c_str(), vtkVersion().c_str());
  std::vector<Subject> list = subjects();
  list.push_back({"torus 128", load("phantom:torus:128"), 0.0});
  for (const Subject& subject : list) {
    std::printf(" %s, %d x %d\n", subject.name.c_str(), pictureSize.x, pictureSize.y);
    compare(context, subject);
  }
}

const Registration registration("vtk",
                                "Isolux against VTK's GPU isosurface mapper and VTK's mesh, on one driver",
                                run);

}  // namespace
}  // namespace isolux::bench
