// Numbers that C++ and the shaders must agree on; tests/render/passes/constants_test.cpp compares them with
// the GLSL.
#pragma once

namespace isolux::render {

// Stands for a missing voxel in a float32 volume texture, whose real values are at most 2^40 in magnitude
// (volume/field/value_scaling.h; field.glsl). A number, not NaN: GLSL compilers may assume that NaN does not
// occur.
inline constexpr float missingTexel = 1e30f;

// Stands for no offset to an edge, in an image of offsets in mm (edge.frag.glsl, measures.glsl).
inline constexpr float kNoEdge = 1e30f;

// Stands for no value of the second volume (second_volume.glsl).
inline constexpr float kNoValue = 3e38f;

}  // namespace isolux::render
