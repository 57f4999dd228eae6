// The faces between active and inactive blocks: the geometry that says where rays start and end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::render {

// One face as a number: 6 * index of the block (x fastest) + 2 * axis of the normal + 1 when the face is on
// the block's high side.
using PackedFace = std::uint32_t;
constexpr std::size_t kMostFaceBlocks = (std::size_t{1} << 32) / 6;  // that have such numbers

// Outward faces of the active blocks toward inactive blocks and toward the volume's outside.
// `active`: one byte per block, x fastest.
std::vector<PackedFace> boundaryFaces(const std::vector<std::uint8_t>& active, glm::ivec3 blockDims);

// The same set of faces, kept from one isovalue to the next: only faces of blocks that change are touched,
// and the parts of the array that were written are known, so that a buffer can follow without being made
// anew. Faces are in no particular order. 24 bytes per block beside the faces.
class BlockFaceSet {
 public:
  struct Range {
    std::size_t first, count;  // in faces
  };

  // No block is active.
  explicit BlockFaceSet(glm::ivec3 blockDims);

  // `active`: the flags after the change; `changed`: the blocks whose flag is not what it was at the last
  // update (volume::ActiveBlocks::update() gives both). Where many blocks change all faces are found anew.
  void update(const std::vector<std::uint8_t>& active, std::span<const std::uint32_t> changed);

  const std::vector<PackedFace>& faces() const { return faces_; }

  // The parts of faces() written since the last call, in whole pages: ascending, apart, within
  // faces().size().
  static constexpr std::size_t kPageFaces = 256;
  std::vector<Range> takeDirty();

 private:
  void rebuild(const std::vector<std::uint8_t>& active);
  void updateBlock(const std::vector<std::uint8_t>& active, std::uint32_t block);
  void setFace(PackedFace face, bool wanted);
  void write(std::size_t place, PackedFace face);

  glm::ivec3 dims_;
  std::vector<PackedFace> faces_;
  std::vector<std::uint32_t> places_;  // of every face that there can be: where it stands in faces_
  std::vector<std::uint8_t> dirtyPages_;
};

}  // namespace isolux::render
