#include "gi/trace/primary_hits.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "scene/albedo.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_cubic_hit.h"

namespace isolux::gi {

namespace {

// Rays of an orthographic camera start behind its eye where the volume does.
double rayStart(const scene::CameraFrame& frame, const volume::GridGeometry& geometry) {
  if (frame.projection != scene::Projection::orthographic) return 0.0;
  volume::Bounds<double> depths;
  for (const glm::dvec3& corner : geometry.corners()) depths.add(-glm::dot(corner - frame.eye, frame.back));
  return std::min(0.0, depths.low - 0.01 * depths.size());
}

}  // namespace

PrimaryHits::PrimaryHits(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
                         glm::ivec2 size, base::Progress& progress)
    : volume_(std::move(volume)),
      size_(size),
      frame_(scene::frameOf(resolved.camera)),
      voxelFromWorld_(volume_->grid().geometry().voxelFromWorld()),
      rayStartMm_(rayStart(frame_, volume_->grid().geometry())),
      insideAbove_(resolved.isosurface.inside == scene::Inside::above),
      field_(resolved.hit.field) {
  const bool mapped = resolved.isosurface.albedoSource == scene::AlbedoSource::map;
  const scene::AlbedoOfIsovalue map(resolved);
  for (const auto& surface : scene::shownSurfaces(resolved)) {
    const double isovalue = surface.value.value();
    surfaces_.push_back({isovalue, mapped ? map.at(isovalue) : glm::vec3(surface.albedo), surface.specular,
                         surface.roughness});
  }
  hidden_ = volume::hiddenOf(resolved, *volume_->pieces, progress);
  cubic_ = volume_->cubicFields->make(field_, progress);
  cut_ = volume::SurfaceCut(resolved, volume_->grid().geometry());
  if (scene::showsCutFaces(resolved)) {
    volume_->cubicFields->make(resolved.slice.field, progress);
    faces_.emplace(volume_->grid(), *volume_->cubicFields, resolved, hidden_);
  }
  normalField_ = volume_->cubicFields->make(resolved.derivatives.field,
                                            resolved.derivatives.normalScale.value_or(0.0), progress);
}

glm::dvec2 PrimaryHits::ndcOf(glm::ivec2 pixel) const {
  return {(pixel.x + 0.5) / size_.x * 2.0 - 1.0, 1.0 - (pixel.y + 0.5) / size_.y * 2.0};
}

std::optional<volume::RayHit> PrimaryHits::cast(double isovalue, volume::Ray ray) const {
  const volume::HiddenPieces hidden = volume::hiddenAt(hidden_, isovalue);
  for (const auto& [begin, end] : cut_.segmentsOf(isovalue, ray)) {
    ray.tMinimum = begin;
    ray.tMaximum = end;
    const volume::CubicHit first =
        volume::firstHitOfField(volume_->grid(), field_, cubic_ ? cubic_->coefficients.get() : nullptr,
                                cubic_ ? cubic_->blocks : *volume_->blocks, isovalue, ray, hidden);
    if (first.hit) return first.hit;
  }
  return std::nullopt;
}

std::optional<PrimaryHit> PrimaryHits::at(glm::ivec2 pixel) const {
  const scene::Ray world = scene::rayThrough(frame_, ndcOf(pixel), static_cast<double>(size_.x) / size_.y);
  volume::Ray ray;
  ray.origin = glm::dvec3(voxelFromWorld_ * glm::dvec4(world.origin, 1.0));
  ray.direction = glm::dmat3(voxelFromWorld_) * world.direction;
  ray.tMinimum = rayStartMm_;
  std::optional<PrimaryHit> nearest;
  double t = std::numeric_limits<double>::infinity();
  if (faces_)
    if (const std::optional<volume::CutFace> face = faces_->at(ray)) t = ray.tMaximum = face->t;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const std::optional<volume::RayHit> hit = cast(surfaces_[i].isovalue, ray);
    if (!hit || !(hit->t < t)) continue;
    t = hit->t;
    nearest = {hit->voxel, static_cast<int>(i), hit->entering == insideAbove_};
  }
  return nearest;
}

glm::vec3 PrimaryHits::direction(glm::ivec2 pixel) const {
  return glm::vec3(scene::rayThrough(frame_, ndcOf(pixel), static_cast<double>(size_.x) / size_.y).direction);
}

glm::vec3 PrimaryHits::backgroundDirection(glm::ivec2 pixel) const {
  if (frame_.projection != scene::Projection::orthographic) return direction(pixel);
  const glm::dvec2 extent = ndcOf(pixel) * (frame_.halfHeight / frame_.distance);
  const double aspect = static_cast<double>(size_.x) / size_.y;
  return glm::vec3(glm::normalize(extent.x * aspect * frame_.right + extent.y * frame_.up - frame_.back));
}

}  // namespace isolux::gi
