// Derivatives and curvature against Teem's gage (Kindlmann), an independent implementation of the same
// kernel, on real CT scans.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <teem/gage.h>
#include <teem/nrrd.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rays.h"
#include "tests/support/test_data.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

// A probe of the B-spline of a grid's values. gage works in double precision throughout; derivatives are in
// world space, because the volume carries its axes' directions.
class Gage {
 public:
  explicit Gage(const Grid& grid) : nrrd_(nrrdNew()), context_(gageContextNew()) {
    const glm::ivec3 dims = grid.dims();
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) values_.push_back(grid.value(x, y, z));
    const std::size_t sizes[3] = {static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.y),
                                  static_cast<std::size_t>(dims.z)};
    bool failed = nrrdWrap_nva(nrrd_.get(), values_.data(), nrrdTypeDouble, 3, sizes) != 0;
    failed = failed || nrrdSpaceSet(nrrd_.get(), nrrdSpaceLeftPosteriorSuperior) != 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      nrrd_->axis[axis].center = nrrdCenterNode;
      nrrd_->axis[axis].kind = nrrdKindSpace;
      for (unsigned row = 0; row < 3; ++row) {
        const int column = static_cast<int>(axis), component = static_cast<int>(row);
        nrrd_->axis[axis].spaceDirection[row] = grid.geometry().worldFromVoxel[column][component];
        if (axis == 0) nrrd_->spaceOrigin[row] = grid.geometry().worldFromVoxel[3][component];
      }
    }
    gagePerVolume* volume = failed ? nullptr : gagePerVolumeNew(context_.get(), nrrd_.get(), gageKindScl);
    failed = !volume || gagePerVolumeAttach(context_.get(), volume) != 0;
    const double parameters[NRRD_KERNEL_PARMS_NUM] = {};
    failed = failed || gageKernelSet(context_.get(), gageKernel00, nrrdKernelBSpline3, parameters) != 0 ||
             gageKernelSet(context_.get(), gageKernel11, nrrdKernelBSpline3D, parameters) != 0 ||
             gageKernelSet(context_.get(), gageKernel22, nrrdKernelBSpline3DD, parameters) != 0;
    for (const int item :
         {gageSclValue, gageSclGradVec, gageSclHessian, gageSclK1, gageSclK2, gageSclCurvDir1})
      failed = failed || gageQueryItemOn(context_.get(), volume, item) != 0;
    if (!failed) gageParmSet(context_.get(), gageParmRenormalize, 0.0);
    failed = failed || gageUpdate(context_.get()) != 0;
    if (failed) throw std::runtime_error("gage could not be set up");
    volume_ = volume;
  }

  void probe(glm::dvec3 voxel) {
    if (gageProbe(context_.get(), voxel.x, voxel.y, voxel.z) != 0)
      throw std::runtime_error("gageProbe failed");
  }
  double scalar(int item) const { return *gageAnswerPointer(context_.get(), volume_, item); }
  glm::dvec3 vector(int item) const {
    const double* v = gageAnswerPointer(context_.get(), volume_, item);
    return {v[0], v[1], v[2]};
  }
  glm::dmat3 hessian() const {
    const double* h = gageAnswerPointer(context_.get(), volume_, gageSclHessian);
    return {h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8]};
  }

 private:
  struct Free {
    void operator()(Nrrd* nrrd) const { nrrdNix(nrrd); }  // the values are ours
    void operator()(gageContext* context) const { gageContextNix(context); }
  };
  std::vector<double> values_;
  std::unique_ptr<Nrrd, Free> nrrd_;
  std::unique_ptr<gageContext, Free> context_;
  gagePerVolume* volume_ = nullptr;
};

struct Differences {
  double value = 0.0, gradient = 0.0, hessian = 0.0, kappa = 0.0, direction = 0.0;  // largest, relative
  int points = 0;
};

// At points of the isosurface found by rays. gage's curvatures have our sign: positive on a bright ball, K1
// >= K2.
Differences compare(const std::string& file, double isovalue) {
  base::Progress progress;
  const auto grid = readVolume((test::dataFolder() / "volumes" / file).string(), {}, progress).grid;
  const MinMaxBlocks blocks(*grid, 8, progress);
  Gage gage(*grid);
  Differences worst;
  const auto atLeast = [](double& figure, double value) { figure = std::max(figure, value); };
  const auto largest = [](const glm::dmat3& m) {
    return std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  };
  for (std::uint64_t i = 0; i < 12000; ++i) {
    const Ray ray = test::randomRay(i, grid->dims());
    const auto hit = firstHit(*grid, blocks, isovalue, ray);
    if (!hit) continue;
    const glm::dvec3 fromBorder = glm::min(hit->voxel, glm::dvec3(grid->dims() - 1) - hit->voxel);
    if (std::min({fromBorder.x, fromBorder.y, fromBorder.z}) < 2.0) continue;  // gage asks for all 64 samples
    const FieldSample sample = sampleCubic(*grid, hit->voxel);
    const glm::dvec3 g = worldGradient(grid->geometry(), sample.gradient);
    const glm::dmat3 h = worldHessian(grid->geometry(), sample.hessian);
    const PrincipalCurvature k = principalCurvature(g, h);
    gage.probe(hit->voxel);
    ++worst.points;
    const double range = grid->maximum() - grid->minimum();
    // Relative to what the voxels allow, so that where a derivative all but cancels its rounding does not
    // count.
    const double size = range / grid->geometry().spacingMm().x;
    atLeast(worst.value, std::abs(gage.scalar(gageSclValue) - sample.value) / range);
    atLeast(worst.gradient, glm::distance(gage.vector(gageSclGradVec), g) / size);
    atLeast(worst.hessian, largest(gage.hessian() - h) / size);
    if (glm::length(g) < 1e-4 * size) continue;  // curvature is a quotient by |g|
    const double curvedness = std::hypot(k.kappa1, k.kappa2) + largest(h) / glm::length(g);
    atLeast(worst.kappa, std::abs(gage.scalar(gageSclK1) - k.kappa1) / curvedness);
    atLeast(worst.kappa, std::abs(gage.scalar(gageSclK2) - k.kappa2) / curvedness);
    // gage's direction is an eigenvector of a 3x3 tensor, in which kappa1 = 0 and the normal's 0 are one.
    if (k.kappa1 - k.kappa2 > 0.05 * curvedness && std::abs(k.kappa1) > 1e-3 * curvedness)
      atLeast(worst.direction, 1.0 - std::abs(glm::dot(gage.vector(gageSclCurvDir1), k.direction1)));
  }
  std::printf(
      "%s, isovalue %g, %d points, largest relative differences from gage: value %.1e, gradient %.1e, "
      "Hessian %.1e, "
      "kappa %.1e, direction %.1e\n",
      file.c_str(), isovalue, worst.points, worst.value, worst.gradient, worst.hessian, worst.kappa,
      worst.direction);
  return worst;
}

void expectRounding(const Differences& d) {
  EXPECT_GT(d.points, 3000);
  EXPECT_LT(d.value, 1e-12);
  EXPECT_LT(d.gradient, 1e-12);
  EXPECT_LT(d.hessian, 1e-12);
  EXPECT_LT(d.kappa, 1e-12);
  EXPECT_LT(d.direction, 1e-12);
}

TEST(CurvatureAgainstGage, OnACtOfAHead) {
  ISOLUX_NEEDS_DATA();
  expectRounding(compare("ct_head_skin_bone.nii.gz", 0.51));
  expectRounding(compare("ct_head_skin_bone.nii.gz", 0.196));
}

TEST(CurvatureAgainstGage, OnACtOfAnisotropicSpacing) {
  ISOLUX_NEEDS_DATA();
  expectRounding(compare("ct_cranium.mhd", 300.0));
}

TEST(CurvatureAgainstGage, OnACtWithObliqueAxes) {
  ISOLUX_NEEDS_DATA();
  expectRounding(compare("ct_head_pitch.nii.gz", 100.0));
}

}  // namespace
}  // namespace isolux::volume
