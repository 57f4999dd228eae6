// Defines numbers that C++ and the shaders share; tests/render/passes/constants_test.cpp compares them with
// the GLSL.
#pragma once

namespace isolux::render {

// Marks a missing voxel in a float32 volume texture, whose real values are at most 2^40 in magnitude
// (volume/field/value_scaling.h; field.glsl). It is not NaN, because GLSL compilers may assume that NaN does
// not occur.
inline constexpr float missingTexel = 1e30f;

// Marks a pixel without an edge in an image of edge offsets in mm (edge.frag.glsl, measures.glsl).
inline constexpr float kNoEdge = 1e30f;

// Marks a pixel without a value of the second volume (second_volume.glsl).
inline constexpr float kNoValue = 3e38f;

}  // namespace isolux::render
