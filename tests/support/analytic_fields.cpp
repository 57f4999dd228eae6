#include "tests/support/analytic_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace isolux::test {

namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
constexpr double kPi = std::numbers::pi;

dmat3 outer(dvec3 a, dvec3 b) {
  return glm::outerProduct(a, b);
}

// Smallest positive root of a t^2 + b t + c.
std::optional<double> smallestPositive(double a, double b, double c) {
  if (a == 0.0) {
    const double t = -c / b;
    return b != 0.0 && t > 0.0 ? std::optional(t) : std::nullopt;
  }
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant <= 0.0) return std::nullopt;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double t0 = q / a, t1 = q != 0.0 ? c / q : 0.0;
  if (t0 > t1) std::swap(t0, t1);
  if (t0 > 0.0) return t0;
  return t1 > 0.0 ? std::optional(t1) : std::nullopt;
}

// Steps no longer than |f - isovalue| / lipschitz cannot pass a crossing.
std::optional<double> lipschitzHit(const AnalyticField& field, dvec3 origin, dvec3 direction, double isovalue,
                                   double lipschitz, double farthest) {
  constexpr double smallest = 1e-10;
  const auto f = [&](double t) { return field.at(origin + t * direction).value - isovalue; };
  double t = 0.0, value = f(0.0);
  const bool startsInside = value >= 0.0;
  while (t < farthest) {
    t += std::max(std::abs(value) / lipschitz, smallest);
    value = f(t);
    if ((value >= 0.0) != startsInside) return t;
  }
  return std::nullopt;
}

class Ball : public AnalyticField {
 public:
  Ball(dvec3 centre, double radius) : c_(centre), radius_(radius) {}
  Derivatives at(dvec3 p) const override {
    const dvec3 q = p - c_;
    const double r = glm::length(q);
    const dvec3 u = q / r;
    return {radius_ - r, -u, -(dmat3(1.0) - outer(u, u)) / r};
  }
  Curvature curvature(dvec3 p) const override {
    const double k = 1.0 / glm::length(p - c_);
    return {k, k};
  }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    const dvec3 q = o - c_;
    const double r = radius_ - iso;
    return smallestPositive(1.0, 2.0 * glm::dot(q, d), glm::dot(q, q) - r * r);
  }

 private:
  dvec3 c_;
  double radius_;
};

class Torus : public AnalyticField {
 public:
  Torus(dvec3 centre, double major, double minor) : c_(centre), major_(major), minor_(minor) {}
  Derivatives at(dvec3 p) const override {
    // With s the distance from the axis, d the distance from the core circle: f = minor - d.
    const dvec3 q = p - c_;
    const double s = glm::length(dvec2(q));
    const dvec3 es(q.x / s, q.y / s, 0.0), ez(0.0, 0.0, 1.0), around(-es.y, es.x, 0.0);
    const double d = std::hypot(s - major_, q.z);
    const dvec3 u = ((s - major_) * es + q.z * ez) / d;  // away from the core
    const dvec3 v = (-q.z * es + (s - major_) * ez) / d;
    // The distance to a curve: 1/d across in the meridian plane, cos/s along the parallel.
    const double along = (s - major_) / d / s;
    return {minor_ - d, -u, -(outer(v, v) / d + outer(around, around) * along)};
  }
  Curvature curvature(dvec3 p) const override {
    const dvec3 q = p - c_;
    const double s = glm::length(dvec2(q)), d = std::hypot(s - major_, q.z);
    const double a = 1.0 / d, b = (s - major_) / (d * s);
    return {std::max(a, b), std::min(a, b)};
  }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    return lipschitzHit(*this, o, d, iso, 1.0, glm::length(o - c_) + 2.0 * (major_ + minor_));
  }

 private:
  dvec3 c_;
  double major_, minor_;
};

class Cylinder : public AnalyticField {
 public:
  Cylinder(dvec3 centre, double radius) : c_(centre), radius_(radius) {}
  Derivatives at(dvec3 p) const override {
    const dvec3 q(p.x - c_.x, p.y - c_.y, 0.0);
    const double s = glm::length(q);
    const dvec3 around(-q.y / s, q.x / s, 0.0);
    return {radius_ - s, -q / s, -outer(around, around) / s};
  }
  Curvature curvature(dvec3 p) const override { return {1.0 / glm::length(dvec2(p - c_)), 0.0}; }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    const dvec2 q(o - c_), e(d);
    const double r = radius_ - iso;
    return smallestPositive(glm::dot(e, e), 2.0 * glm::dot(q, e), glm::dot(q, q) - r * r);
  }

 private:
  dvec3 c_;
  double radius_;
};

class Plane : public AnalyticField {
 public:
  explicit Plane(dvec3 centre) : c_(centre), n_(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0) {}
  Derivatives at(dvec3 p) const override { return {-glm::dot(n_, p - c_), -n_, dmat3(0.0)}; }
  Curvature curvature(dvec3) const override { return {}; }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    return smallestPositive(0.0, -glm::dot(n_, d), -glm::dot(n_, o - c_) - iso);
  }

 private:
  dvec3 c_, n_;
};

class Saddle : public AnalyticField {
 public:
  Saddle(dvec3 centre, double edge) : c_(centre), a_(2.0 / edge) {}
  Derivatives at(dvec3 p) const override {
    const dvec3 q = p - c_;
    dmat3 hessian(0.0);
    hessian[0][0] = 2.0 * a_;
    hessian[1][1] = -2.0 * a_;
    return {a_ * (q.x * q.x - q.y * q.y) - q.z, {2.0 * a_ * q.x, -2.0 * a_ * q.y, -1.0}, hessian};
  }
  Curvature curvature(dvec3 p) const override {
    // The graph z = h(x, y) - isovalue, whose normal here points up: K and H of a Monge patch.
    const dvec3 q = p - c_;
    const double hx = 2.0 * a_ * q.x, hy = -2.0 * a_ * q.y, hxx = 2.0 * a_, hyy = -2.0 * a_;
    const double w = 1.0 + hx * hx + hy * hy;
    const double gauss = hxx * hyy / (w * w);
    const double mean = -((1.0 + hy * hy) * hxx + (1.0 + hx * hx) * hyy) / (2.0 * w * std::sqrt(w));
    const double root = std::sqrt(std::max(mean * mean - gauss, 0.0));
    return {mean + root, mean - root};
  }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    const dvec3 q = o - c_;
    return smallestPositive(a_ * (d.x * d.x - d.y * d.y), 2.0 * a_ * (q.x * d.x - q.y * d.y) - d.z,
                            a_ * (q.x * q.x - q.y * q.y) - q.z - iso);
  }

 private:
  dvec3 c_;
  double a_;
};

class Gyroid : public AnalyticField {
 public:
  Gyroid(dvec3 centre, double edge) : c_(centre), edge_(edge), k_(8.0 * kPi / edge) {}
  Derivatives at(dvec3 p) const override {
    const dvec3 q = (p - c_) * k_, s = glm::sin(q), c = glm::cos(q);
    Derivatives out;
    out.value = s.x * c.y + s.y * c.z + s.z * c.x;
    out.gradient = k_ * dvec3(c.x * c.y - s.z * s.x, c.y * c.z - s.x * s.y, c.z * c.x - s.y * s.z);
    dmat3& h = out.hessian;
    h[0][0] = -s.x * c.y - s.z * c.x;
    h[1][1] = -s.y * c.z - s.x * c.y;
    h[2][2] = -s.z * c.x - s.y * c.z;
    h[0][1] = h[1][0] = -c.x * s.y;
    h[1][2] = h[2][1] = -c.y * s.z;
    h[2][0] = h[0][2] = -c.z * s.x;
    h *= k_ * k_;
    return out;
  }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    return lipschitzHit(*this, o, d, iso, k_ * std::sqrt(3.0), 4.0 * edge_);
  }

 private:
  dvec3 c_;
  double edge_, k_;
};

class MarschnerLobb : public AnalyticField {
 public:
  MarschnerLobb(dvec3 centre, double edge) : c_(centre), edge_(edge), k_(2.0 / edge) {}
  Derivatives at(dvec3 p) const override {
    // f = (1 - sin(pi Z/2) + alpha (1 + g(r))) / (2 (1 + alpha)), g(r) = cos(b cos(pi r/2)), b = 2 pi f_M.
    constexpr double alpha = 0.25, b = 12.0 * kPi, h = 0.5 * kPi, scale = 1.0 / (2.0 * (1.0 + alpha));
    const dvec3 q = (p - c_) * k_;
    const double r = glm::length(dvec2(q));
    const double u = b * std::cos(h * r), u1 = -b * h * std::sin(h * r), u2 = -h * h * u;
    const double g = std::cos(u), g1 = -std::sin(u) * u1, g2 = -std::cos(u) * u1 * u1 - std::sin(u) * u2;
    const double g1OverR = r > 1e-9 ? g1 / r : g2;
    const dvec3 e = r > 1e-9 ? dvec3(q.x / r, q.y / r, 0.0) : dvec3(1.0, 0.0, 0.0);
    const dvec3 around(-e.y, e.x, 0.0);
    Derivatives out;
    out.value = scale * (1.0 - std::sin(h * q.z) + alpha * (1.0 + g));
    out.gradient = scale * k_ * (alpha * g1 * e + dvec3(0.0, 0.0, -h * std::cos(h * q.z)));
    out.hessian = alpha * (g2 * outer(e, e) + g1OverR * outer(around, around));
    out.hessian[2][2] = h * h * std::sin(h * q.z);
    out.hessian *= scale * k_ * k_;
    return out;
  }
  std::optional<double> firstHit(dvec3 o, dvec3 d, double iso) const override {
    const double radial = 0.25 * 12.0 * kPi * 0.5 * kPi / 2.5, axial = 0.5 * kPi / 2.5;
    return lipschitzHit(*this, o, d, iso, k_ * std::hypot(radial, axial), 4.0 * edge_);
  }

 private:
  dvec3 c_;
  double edge_, k_;
};

volume::GridGeometry centred(int size, dvec3 spacing, const dmat3& directions) {
  const dvec3 half = spacing * (0.5 * (size - 1));
  return volume::GridGeometry::make(glm::ivec3(size), spacing, dvec3(5.0, -7.0, 11.0) - directions * half,
                                    directions);
}

}  // namespace

glm::dvec3 AnalyticField::normal(glm::dvec3 world) const {
  return -glm::normalize(at(world).gradient);
}

Curvature AnalyticField::curvature(glm::dvec3 world) const {
  return curvatureOf(at(world));
}

Curvature curvatureOf(const Derivatives& derivatives) {
  const dvec3 g = derivatives.gradient;
  const dmat3& h = derivatives.hessian;
  const double length = glm::length(g);
  const dvec3 n = g / length;
  // S = -P H P / |g|: its trace, and the sum of its principal minors (from tr and the square's trace).
  const dmat3 projector = dmat3(1.0) - outer(n, n);
  const dmat3 s = projector * h * projector * (-1.0 / length);
  const dmat3 square = s * s;
  const double trace = s[0][0] + s[1][1] + s[2][2], squareTrace = square[0][0] + square[1][1] + square[2][2];
  const double root = std::sqrt(std::max(2.0 * squareTrace - trace * trace, 0.0));
  return {0.5 * (trace + root), 0.5 * (trace - root)};
}

Derivatives differences(const std::function<double(glm::dvec3)>& value, glm::dvec3 world, double step) {
  Derivatives out;
  out.value = value(world);
  for (int i = 0; i < 3; ++i) {
    dvec3 a(0.0);
    a[i] = step;
    out.gradient[i] = (value(world + a) - value(world - a)) / (2.0 * step);
    for (int j = 0; j < 3; ++j) {
      dvec3 b(0.0);
      b[j] = step;
      out.hessian[i][j] =
          (value(world + a + b) - value(world + a - b) - value(world - a + b) + value(world - a - b)) /
          (4.0 * step * step);
    }
  }
  return out;
}

std::unique_ptr<AnalyticField> analyticField(const std::string& name, const volume::GridGeometry& geometry) {
  // The middle of the box, as the mean of two opposite corners; its edges, from corner to corner.
  const auto corner = [&](int x, int y, int z) {
    return dvec3(geometry.worldFromVoxel * glm::dvec4(x, y, z, 1.0));
  };
  const glm::ivec3 last = geometry.dims - 1;
  const dvec3 first = corner(0, 0, 0), c = 0.5 * (first + corner(last.x, last.y, last.z));
  const double e = std::min({glm::distance(first, corner(std::max(last.x, 1), 0, 0)),
                             glm::distance(first, corner(0, std::max(last.y, 1), 0)),
                             glm::distance(first, corner(0, 0, std::max(last.z, 1)))});
  if (name == "ball") return std::make_unique<Ball>(c, 0.35 * e);
  if (name == "torus") return std::make_unique<Torus>(c, 0.27 * e, 0.12 * e);
  if (name == "cylinder") return std::make_unique<Cylinder>(c, 0.25 * e);
  if (name == "plane") return std::make_unique<Plane>(c);
  if (name == "saddle") return std::make_unique<Saddle>(c, e);
  if (name == "gyroid") return std::make_unique<Gyroid>(c, e);
  if (name == "marschner_lobb") return std::make_unique<MarschnerLobb>(c, e);
  throw std::invalid_argument("no closed form for " + name);
}

volume::GridGeometry isotropicGeometry(int size) {
  return centred(size, dvec3(1.0), dmat3(1.0));
}

volume::GridGeometry anisotropicGeometry(int size) {
  return centred(size, {0.4, 0.4, 2.5}, dmat3(1.0));
}

volume::GridGeometry obliqueLeftHandedGeometry(int size) {
  // Orthogonal directions of determinant -1, none along a world axis: a reflection across a tilted plane.
  const dvec3 n = glm::normalize(dvec3(1.0, -2.0, 0.6));
  return centred(size, {0.8, 1.1, 1.4}, dmat3(1.0) - 2.0 * outer(n, n));
}

}  // namespace isolux::test
