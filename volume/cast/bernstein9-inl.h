// Finds where a polynomial of degree 9 in each lane first leaves the side that a ray is on, with a bound that
// makes a miss impossible: as firstRoot9() of resources/shaders/cast/trace_cubic.glsl. Included once per
// instruction set by simd_cast-inl.h.
//
// It lies in the hull of its Bernstein coefficients. Those that do not change sign have no root, those that
// change it once have one (variation diminishing, Farin 2002); else the interval is halved, front half first.
#if defined(ISOLUX_VOLUME_CAST_BERNSTEIN9_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_BERNSTEIN9_INL_H
#undef ISOLUX_VOLUME_CAST_BERNSTEIN9_INL_H
#else
#define ISOLUX_VOLUME_CAST_BERNSTEIN9_INL_H
#endif

#include "volume/cast/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// In Bernstein form on [0, 1].
struct Bernstein9 {
  VF b[10];

  HWY_INLINE VF start() const { return b[0]; }
  HWY_INLINE Bernstein9 minus(float shift) const {
    Bernstein9 out;
    for (int i = 0; i < 10; ++i) out.b[i] = hn::Sub(b[i], hn::Set(F(), shift));
    return out;
  }
  HWY_INLINE Bernstein9 startingAt(VF value) const {
    Bernstein9 out = *this;
    out.b[0] = value;
    return out;
  }
  static HWY_INLINE Bernstein9 zero() {
    Bernstein9 out;
    for (VF& b : out.b) b = hn::Zero(F());
    return out;
  }
  static HWY_INLINE Bernstein9 select(MF first, const Bernstein9& a, const Bernstein9& b) {
    Bernstein9 out;
    for (int i = 0; i < 10; ++i) out.b[i] = hn::IfThenElse(first, a.b[i], b.b[i]);
    return out;
  }
  // Positive where its lane is on the side `inside`. 0 is inside: outside is what is at least 1e-30 below.
  HWY_INLINE Bernstein9 onSide(MF inside) const {
    Bernstein9 out;
    for (int i = 0; i < 10; ++i)
      out.b[i] = hn::IfThenElse(inside, b[i], hn::Sub(hn::Set(F(), -1e-30f), b[i]));
    return out;
  }
};

// The part [at, at + width] of a polynomial as one on [0, 1]: de Casteljau, by convex combinations alone.
inline Bernstein9 partOf(const Bernstein9& whole, VF at, VF width) {
  const VF one = hn::Set(F(), 1.0f);
  const auto mix = [](VF a, VF b, VF s, VF rest) { return hn::MulAdd(s, b, hn::Mul(rest, a)); };
  Bernstein9 c = whole;
  const VF before = hn::Sub(one, at);
  for (int r = 1; r < 10; ++r)
    for (int i = 0; i < 10 - r; ++i) c.b[i] = mix(c.b[i], c.b[i + 1], at, before);
  const VF s = hn::Min(hn::Div(width, before), one), rest = hn::Sub(one, s);
  for (int r = 1; r < 10; ++r)
    for (int i = 9; i >= r; --i) c.b[i] = mix(c.b[i - 1], c.b[i], s, rest);
  return c;
}

// How often the coefficients change sign.
struct SignChanges {
  MF any, many;
};

HWY_INLINE SignChanges signChangesOf(const Bernstein9& c) {
  SignChanges changes{noLane(), noLane()};
  MF before = hn::Lt(c.b[0], hn::Zero(F()));
  for (int i = 1; i < 10; ++i) {
    const MF below = hn::Lt(c.b[i], hn::Zero(F())), change = hn::Xor(below, before);
    changes.many = hn::Or(changes.many, hn::And(changes.any, change));
    changes.any = hn::Or(changes.any, change);
    before = below;
  }
  return changes;
}

// The part of [0, 1] with the only first root; of width 0 where the side is left already.
struct Change9 {
  MF found, undecided;  // undecided: a touch was not resolved even in the smallest interval, and passed over
  VF at, width;
};

// The next of the intervals that halving makes, as wide as it may be; perUnit: 1 / width.
HWY_INLINE void goOn(MF lanes, VF& at, VF& perUnit) {
  const F f;
  const VF half = hn::Set(f, 0.5f), one = hn::Set(f, 1.0f);
  at = hn::IfThenElse(lanes, hn::Add(at, hn::Div(one, perUnit)), at);
  for (;;) {
    const VF index = hn::Mul(at, hn::Mul(half, perUnit));  // of the interval twice as wide
    const MF even = hn::And(hn::Eq(index, hn::Floor(index)), hn::Gt(perUnit, one));
    const MF widened = hn::And(lanes, even);
    if (hn::AllFalse(f, widened)) return;
    perUnit = hn::IfThenElse(widened, hn::Mul(half, perUnit), perUnit);
  }
}

// onSide: positive where its lane is on its side.
inline Change9 firstChange(const Bernstein9& onSide, MF unresolved) {
  const F f;
  constexpr float finest = 4096.0f;
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  Change9 change{noLane(), noLane(), zero, zero};
  VF at = zero, perUnit = one;
  for (int step = 0; step < 128; ++step) {
    const VF width = hn::Div(one, perUnit);
    const Bernstein9 c = step == 0 ? onSide : partOf(onSide, at, width);
    const MF entry = hn::And(unresolved, hn::Lt(c.b[0], zero));
    const SignChanges changes = signChangesOf(c);
    const MF ends = hn::Or(entry, hn::And(unresolved, hn::AndNot(changes.many, changes.any)));
    change.found = hn::Or(change.found, ends);
    change.at = hn::IfThenElse(ends, at, change.at);
    change.width = hn::IfThenElse(hn::AndNot(entry, ends), width, change.width);
    unresolved = hn::AndNot(ends, unresolved);
    const MF unclear = hn::And(unresolved, changes.many);
    const MF halved = hn::And(unclear, hn::Lt(perUnit, hn::Set(f, finest)));
    change.undecided = hn::Or(change.undecided, hn::AndNot(halved, unclear));
    perUnit = hn::IfThenElse(halved, hn::Add(perUnit, perUnit), perUnit);
    goOn(hn::AndNot(halved, unresolved), at, perUnit);
    unresolved = hn::And(unresolved, hn::Lt(at, one));
    if (hn::AllFalse(f, unresolved)) return change;
  }
  change.undecided = hn::Or(change.undecided, unresolved);
  return change;
}

// Its value by sums of what has one sign each (Farin 2002, 4.2); scaled: its coefficients times C(9, i).
HWY_INLINE VF valueOfScaled(const Bernstein9& scaled, VF s) {
  const VF rest = hn::Sub(hn::Set(F(), 1.0f), s);
  VF sum = scaled.b[0], power = s;
  for (int i = 1; i < 10; ++i) {
    sum = hn::MulAdd(power, scaled.b[i], hn::Mul(sum, rest));
    power = hn::Mul(power, s);
  }
  return sum;
}

// The only root of polynomials that fall through 0: regula falsi, Illinois variant; from the seventh step on
// with bisections between, because it creeps where the polynomial is nearly 0 at an end of the segment, too.
inline VF onlyRoot(const Bernstein9& c, MF unresolved) {
  const F f;
  constexpr float choose[10] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  Bernstein9 scaled;
  for (int i = 0; i < 10; ++i) scaled.b[i] = hn::Mul(c.b[i], hn::Set(f, choose[i]));
  const VF zero = hn::Zero(f), half = hn::Set(f, 0.5f), close = hn::Set(f, 1e-6f);
  VF s0 = zero, s1 = hn::Set(f, 1.0f), f0 = c.b[0], f1 = c.b[9], s = zero;
  MF lastFront = noLane(), lastBack = noLane();  // which end was replaced before
  for (int i = 0; i < 46 && !hn::AllFalse(f, unresolved); ++i) {
    const VF step = hn::Div(hn::Mul(f1, hn::Sub(s1, s0)), hn::Sub(f1, f0));
    const VF next =
        i > 5 && i % 2 == 1 ? hn::Mul(half, hn::Add(s0, s1)) : hn::Min(hn::Max(hn::Sub(s1, step), s0), s1);
    s = hn::IfThenElse(unresolved, next, s);
    const VF value = valueOfScaled(scaled, s);
    unresolved = hn::AndNot(hn::Or(hn::Eq(value, zero), hn::Lt(hn::Sub(s1, s0), close)), unresolved);
    const MF front = hn::Ge(value, zero);
    const VF kept0 = hn::IfThenElse(lastBack, hn::Mul(half, f0), f0);
    const VF kept1 = hn::IfThenElse(lastFront, hn::Mul(half, f1), f1);
    s0 = hn::IfThenElse(front, s, s0);
    s1 = hn::IfThenElse(front, s1, s);
    f0 = hn::IfThenElse(front, value, kept0);
    f1 = hn::IfThenElse(front, kept1, value);
    lastFront = front;
    lastBack = hn::Not(front);
  }
  return s;
}

// Returns the lanes of `here` whose curve leaves its side.
HWY_INLINE MF leavesSide(const Bernstein9& b, MF inside, MF here, MF& undecided) {
  const F f;
  const Bernstein9 onSide = b.onSide(inside);
  VF least = onSide.b[0];
  for (int i = 1; i < 10; ++i) least = hn::Min(least, onSide.b[i]);
  const MF unresolved = hn::And(here, hn::Lt(least, hn::Zero(f)));
  if (hn::AllFalse(f, unresolved)) return unresolved;
  const Change9 change = firstChange(onSide, unresolved);
  undecided = hn::Or(undecided, change.undecided);
  return change.found;
}

// Returns where those curves leave it first.
HWY_INLINE VF firstRoot(const Bernstein9& b, MF inside, MF wanted) {
  const Bernstein9 onSide = b.onSide(inside);
  const Change9 change = firstChange(onSide, wanted);
  const MF within = hn::And(wanted, hn::Gt(change.width, hn::Zero(F())));
  const VF s = onlyRoot(partOf(onSide, change.at, change.width), within);
  return hn::MulAdd(change.width, s, change.at);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
