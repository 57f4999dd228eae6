// Stores a volume as bricks in a cache on the GPU: its textures, the requests of rays, and the uploads.
//
// Rays mark the bricks they use and those they wait for (bricks.glsl). After a round of rays, endRound()
// reads the marks and serve() uploads the requested bricks, evicting the least recently used. Each channel
// (the samples, the coefficients of splines) has one cache texture; a brick has the same slot in all. The
// brick table, a texture, maps bricks to slots. A block of 8^3 cells of a brick is lost if its lookups need
// unreadable voxels of the file. A brick is lost if all its blocks are. Rays end there and do not wait.
// Hadwiger et al. 2005 sec. 3.1.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/volume/brick_cache.h"
#include "render/volume/volume_texture.h"

namespace isolux::render {

class Bricks {
 public:
  // Creates an empty cache. It has as many slots as fit into the budget and the driver's 3D textures, at most
  // one per brick. Throws base::Error{memory} if not even a handful fits. `channels` must outlive this.
  // `apron`: as the lookups need it (brick_cache.h); programs get BRICK_APRON. `moved`: called whenever a
  // brick becomes resident or is evicted.
  using Moved = std::function<void(glm::ivec3 brick, bool isResident, BlockBits lost)>;
  Bricks(GlPtr gl, std::vector<const TexelSource*> channels, int apron, std::size_t budgetBytes,
         Moved moved = {});

  void bind(Program& program) const;  // uBricks, texture unit 15
  // Returns whether rays may reach lost blocks; programs then get LOST_BLOCKS.
  bool mayLoseBlocks() const { return hasBlockBits_; }
  const Texture& texture(std::size_t channel) const { return caches_[channel]; }
  int apron() const { return apron_; }
  std::size_t bytes() const;

  glm::ivec3 dims() const { return dims_; }  // bricks per axis
  std::size_t slots() const { return cache_.slots(); }
  std::size_t resident() const { return cache_.resident(); }
  bool holdsAll() const;  // once resident, a brick stays
  // Returns whether bricks are read from a file that does not stay in memory whole. Requesting neighbours
  // together then reads fewer parts.
  bool readsTwice() const;

  // Begin a frame and a round of rays. The bricks used in a frame's rounds are known until the next frame's
  // first round.
  void beginFrame();
  void beginRound();
  void endRound();
  std::size_t waitingRays() const { return waitingRays_; }  // of the last round
  std::size_t lostRays() const { return lostRays_; }  // of the last round: those that ended at a lost block
  std::size_t lost() const { return lost_.size(); }   // bricks with lost blocks, since construction
  const std::string& lostReason() const { return lostReason_; }  // of the first lost brick: one line

  // Uploads requested bricks, at most `limitBytes` but at least one; those used since the round `kept` stay.
  // Returns their number, including lost ones. Throws base::Error of kinds other than input.
  std::size_t serve(BrickCache::Round kept, std::size_t limitBytes);
  bool canServe(BrickCache::Round kept) const;
  // Returns whether the requested bricks do not fit in addition to the resident ones.
  bool wouldReplace() const { return cache_.resident() + wanted_.size() > cache_.slots(); }
  void forgetWanted() { wanted_.clear(); }
  BrickCache::Round thisRound() const { return cache_.round(); }
  BrickCache::Round frameRound() const { return frameRound_; }  // the first of the frame

  std::size_t uploaded() const { return uploaded_; }  // in this frame
  std::size_t evicted() const { return evicted_; }
  double uploadMilliseconds() const { return uploadMilliseconds_; }  // wall time

 private:
  glm::ivec3 brickAt(BrickCache::Brick brick) const;
  enum class Entry { absent, resident, lost, partlyLost };  // bricks.glsl has the same numbers
  void setEntry(BrickCache::Brick brick, Entry entry) const;
  BlockBits fetch(BrickCache::Brick brick);           // loads its texels; returns the lost blocks
  BlockBits blocksOf(BrickCache::Brick brick) const;  // those that contain cells of the volume
  void upload(BrickCache::Brick brick, BrickCache::Slot slot);

  GlPtr gl_;
  std::vector<const TexelSource*> channels_;
  int apron_;
  Moved moved_;
  glm::ivec3 dims_, slotDims_;
  BrickCache cache_;
  std::vector<Texture> caches_;
  bool hasBlockBits_;  // the table has a second half: the lost blocks of each brick
  Texture table_;
  Buffer use_;  // waiting rays, lost rays, then a mark for each brick
  std::vector<std::uint32_t> marks_;
  std::vector<BrickCache::Brick> wanted_;
  std::vector<std::vector<std::byte>> texels_;  // of a brick, by channel
  std::unordered_map<BrickCache::Brick, BlockBits> lost_;
  std::string lostReason_;
  bool frameBegins_ = true;
  BrickCache::Round frameRound_ = 1;
  std::size_t waitingRays_ = 0, lostRays_ = 0, uploaded_ = 0, evicted_ = 0;
  double uploadMilliseconds_ = 0.0;
};

}  // namespace isolux::render
