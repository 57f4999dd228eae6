#include "base/hash.h"

#include <string_view>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

std::uint64_t byBytes(std::string_view text) {
  Hasher hasher;
  for (const char c : text) hasher.add(c);
  return hasher;
}

std::uint64_t byWords(std::string_view text) {
  return Hasher().addWords(text.data(), text.size());
}

TEST(Hash, IsThatOfItsPublishedExamples) {
  EXPECT_EQ(byBytes(""), 0xcbf29ce484222325ull);
  EXPECT_EQ(byBytes("a"), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(byBytes("foobar"), 0x85944171f73967e8ull);
}

// Hashes of volumes stand in files: they must never change.
TEST(Hash, OfManyBytesTakesThemByEights) {
  EXPECT_EQ(byWords("foobar"), byBytes("foobar")) << "fewer than eight are taken one by one";
  EXPECT_EQ(byWords("isosurfaces of voxels"), 0x1253027aaeccb015ull);
}

TEST(Hash, GoesOnFromWhatWasAddedBefore) {
  const std::string_view text = "isosurfaces of voxels";
  EXPECT_EQ(Hasher().addWords(text.data(), 16).addWords(text.data() + 16, 5), byWords(text));
  EXPECT_EQ(Hasher().add('f').add('o').addWords("obar", 4), byBytes("foobar"));
}

}  // namespace
}  // namespace isolux::base
