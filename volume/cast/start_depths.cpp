#include "volume/cast/start_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "volume/voxels/bounds.h"

namespace isolux::volume {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kWidening = 0.01f;  // pixels: the places of corners are rounded

// Corners of blocks along an axis; the last block ends with the volume.
std::vector<float> planesOf(int blocks, int voxels, int blockCells) {
  std::vector<float> planes(static_cast<std::size_t>(blocks) + 1);
  for (int i = 0; i <= blocks; ++i)
    planes[static_cast<std::size_t>(i)] = static_cast<float>(std::min(i * blockCells, voxels - 1));
  return planes;
}

// A corner of blocks in the picture: pixels, and mm along the view direction. NaN where it has no place.
struct Corners {
  std::vector<float> x, y, depth;
};

Corners project(const PictureRays& rays, glm::ivec3 voxels, const BlockMasks& of) {
  const std::vector<float> xs = planesOf(of.blocks.x, voxels.x, of.blockCells),
                           ys = planesOf(of.blocks.y, voxels.y, of.blockCells),
                           zs = planesOf(of.blocks.z, voxels.z, of.blockCells);
  const glm::mat3 camera(glm::inverse(glm::dmat3(rays.right, rays.up, rays.forward)));
  const glm::vec2 toPixels = 0.5f * glm::vec2(rays.picture) / rays.halfExtent;
  const glm::vec2 middle = 0.5f * glm::vec2(rays.picture) - glm::vec2(rays.origin);
  const float nearest = 1e-3f / glm::length(rays.forward);  // a thousandth of a voxel
  Corners out;
  const std::size_t count = xs.size() * ys.size() * zs.size();
  out.x.resize(count);
  out.y.resize(count);
  out.depth.resize(count);
  std::size_t i = 0;
  for (const float z : zs)
    for (const float y : ys) {
      const glm::vec3 row = camera * (glm::vec3(0.0f, y, z) - rays.eye);
      for (const float x : xs) {
        const glm::vec3 c = row + x * camera[0];
        const float distance = rays.orthographic ? 1.0f : c.z + rays.startDepth;
        const float inverse = distance > nearest ? 1.0f / distance : std::numeric_limits<float>::quiet_NaN();
        out.x[i] = middle.x + c.x * inverse * toPixels.x;
        out.y[i] = middle.y + c.y * inverse * toPixels.y;
        out.depth[i] = c.z;
        ++i;
      }
    }
  return out;
}

// The tiles that pixels lie in, of `count`; empty where first > last.
glm::ivec2 tilesOf(const Bounds<float>& pixels, float tilesPerPixel, int count) {
  const float first = std::floor((pixels.low - kWidening) * tilesPerPixel);
  const float last = std::floor((pixels.high + kWidening) * tilesPerPixel);
  const auto end = static_cast<float>(count);
  return {static_cast<int>(std::clamp(first, 0.0f, end)),
          static_cast<int>(std::clamp(last, -1.0f, end - 1.0f))};
}

}  // namespace

StartDepths startDepths(const PictureRays& rays, glm::ivec2 size, glm::ivec3 voxels, const BlockMasks& of,
                        int tile) {
  StartDepths out;
  const glm::ivec3 blocks = of.blocks;
  const float tilesPerPixel = 1.0f / static_cast<float>(tile);
  out.tiles = (size + (tile - 1)) / tile;
  out.depths.assign(Extent2{out.tiles}.count(), {kFar, -kFar});
  const Corners corners = project(rays, voxels, of);
  const Extent3 cornersOf{blocks + 1};
  const std::size_t row = cornersOf.row(), slice = cornersOf.slice();
  Bounds<float> everywhere;  // depths of blocks that reach from before the eye to behind it
  std::size_t block = 0;
  for (int z = 0; z < blocks.z; ++z)
    for (int y = 0; y < blocks.y; ++y) {
      std::size_t corner = cornersOf.index(0, y, z);
      for (int x = 0; x < blocks.x; ++x, ++block, ++corner) {
        if (of.masks[block] == 0) continue;
        Bounds<float> px, py, depth;
        int placed = 0;
        for (const std::size_t at : {corner, corner + 1, corner + row, corner + row + 1, corner + slice,
                                     corner + slice + 1, corner + slice + row, corner + slice + row + 1}) {
          depth.add(corners.depth[at]);
          if (std::isnan(corners.x[at])) continue;
          ++placed;
          px.add(corners.x[at]);
          py.add(corners.y[at]);
        }
        if (placed == 0) continue;  // behind the eye
        if (placed < 8) {
          everywhere.add(depth);
          continue;
        }
        const glm::ivec2 tx = tilesOf(px, tilesPerPixel, out.tiles.x),
                         ty = tilesOf(py, tilesPerPixel, out.tiles.y);
        for (int tileY = ty.x; tileY <= ty.y; ++tileY) {
          StartDepths::Depths* const line = &out.depths[Extent2{out.tiles}.index(0, tileY)];
          for (int tileX = tx.x; tileX <= tx.y; ++tileX) {
            line[tileX].first = std::min(line[tileX].first, depth.low);
            line[tileX].last = std::max(line[tileX].last, depth.high);
          }
        }
      }
    }
  for (StartDepths::Depths& depths : out.depths) {
    depths.first = std::min(depths.first, everywhere.low);
    depths.last = std::max(depths.last, everywhere.high);
  }
  return out;
}

}  // namespace isolux::volume
