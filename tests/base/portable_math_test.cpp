#include "base/portable_math.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

// Units in the last place of `truth` between the two.
double unitsApart(double value, long double reference) {
  int exponent = 0;
  std::frexp(static_cast<double>(reference), &exponent);
  return static_cast<double>(std::abs(static_cast<long double>(value) - reference) /
                             std::ldexp(1.0L, exponent - 53));
}

template <class Value, class Truth>
double worst(double low, double high, Value value, Truth reference) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> pick(low, high);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double x = pick(random);
    worst = std::max(worst, unitsApart(value(x), reference(static_cast<long double>(x))));
  }
  return worst;
}

TEST(PortableMath, IsWithinAUnitOfTheLastPlace) {
  const auto sine = [](long double x) { return std::sin(x); };
  const auto cosine = [](long double x) { return std::cos(x); };
  for (const double most : {0.8, 7.0, 300.0, 1e5}) {
    EXPECT_LT(worst(-most, most, portableSin, sine), 1.0) << most;
    EXPECT_LT(worst(-most, most, portableCos, cosine), 1.0) << most;
  }
  EXPECT_LT(worst(-50.0, 50.0, portableExp, [](long double x) { return std::exp(x); }), 1.0);
  EXPECT_LT(worst(-700.0, 700.0, portableExp, [](long double x) { return std::exp(x); }), 1.0);
  EXPECT_LT(worst(-1.0, 1.0, portableAcos, [](long double x) { return std::acos(x); }), 1.0);
  EXPECT_LT(worst(0.999, 1.0, portableAcos, [](long double x) { return std::acos(x); }), 1.0);
}

TEST(PortableMath, NumbersThatAreKnownAreMet) {
  EXPECT_EQ(portableSin(0.0), 0.0);
  EXPECT_EQ(portableCos(0.0), 1.0);
  EXPECT_EQ(portableExp(0.0), 1.0);
  EXPECT_EQ(portableAcos(1.0), 0.0);
  EXPECT_EQ(portableAcos(-1.0), std::acos(-1.0));
  EXPECT_EQ(portableExp(-1e9), 0.0);
  EXPECT_EQ(portableExp(1e9), std::numeric_limits<double>::infinity());
}

TEST(PortableMath, WhatHasNoAnswerIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  for (const double x : {none, infinite, -infinite, 2e5}) {
    EXPECT_TRUE(std::isnan(portableSin(x)));
    EXPECT_TRUE(std::isnan(portableCos(x)));
  }
  EXPECT_TRUE(std::isnan(portableExp(none)));
  EXPECT_TRUE(std::isnan(portableAcos(1.0 + 1e-15)));
  EXPECT_TRUE(std::isnan(portableAcos(none)));
}

}  // namespace
}  // namespace isolux::base
