// A volume as bricks in a cache on the GPU: its textures, what rays ask for, and the uploads that answer.
//
// Rays mark the bricks they use and those they wait for (bricks.glsl); after a round of rays endRound() reads
// the marks and serve() uploads what was asked for, replacing what was least recently used. One cache texture
// for each channel (the samples, the coefficients of splines): a brick has the same slot in all. The brick
// table, a texture, says which. Blocks of 8^3 cells of a brick whose lookups need voxels that the file does
// not give are lost, and so is a brick that has no others: rays end there, and wait for nothing. Hadwiger et
// al. 2005 sec. 3.1.
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
  // Nothing is resident yet. The cache takes what fits into the budget and the driver's 3D textures, at most
  // all bricks. Throws base::Error{memory} when not even a handful fits. `channels` outlive this. apron: as
  // the lookups need it (brick_cache.h); programs are told by BRICK_APRON. moved: told whenever a brick has
  // become resident, or has made room.
  using Moved = std::function<void(glm::ivec3 brick, bool isResident, BlockBits lost)>;
  Bricks(GlPtr gl, std::vector<const TexelSource*> channels, int apron, std::size_t budgetBytes,
         Moved moved = {});

  void bind(Program& program) const;  // uBricks, texture unit 15
  // Rays may come to lost blocks: programs are told by LOST_BLOCKS.
  bool mayLoseBlocks() const { return hasBlockBits_; }
  const Texture& texture(std::size_t channel) const { return caches_[channel]; }
  int apron() const { return apron_; }
  std::size_t bytes() const;

  glm::ivec3 dims() const { return dims_; }  // bricks per axis
  std::size_t slots() const { return cache_.slots(); }
  std::size_t resident() const { return cache_.resident(); }
  bool holdsAll() const;  // once resident, a brick stays
  // They come from a file of which not all parts stay in memory: who asks for neighbours together has fewer
  // read.
  bool readsTwice() const;

  // A frame has rounds of rays; what its first and later rounds use is known until the next frame's first
  // round.
  void beginFrame();
  void beginRound();
  void endRound();
  std::size_t waitingRays() const { return waitingRays_; }  // of the last round
  std::size_t lostRays() const { return lostRays_; }        // of the same: those that ended at a lost block
  std::size_t lost() const { return lost_.size(); }         // bricks with lost blocks, since this was made
  const std::string& lostReason() const { return lostReason_; }  // of the first: one line

  // Uploads bricks that were asked for, at most `limitBytes` but at least one; those used since the round
  // `kept` stay. Returns how many, with those that were lost. Throws base::Error of others than kind input.
  std::size_t serve(BrickCache::Round kept, std::size_t limitBytes);
  bool canServe(BrickCache::Round kept) const;
  // What was asked for does not fit beside what is resident.
  bool wouldReplace() const { return cache_.resident() + wanted_.size() > cache_.slots(); }
  void forgetWanted() { wanted_.clear(); }
  BrickCache::Round thisRound() const { return cache_.round(); }
  BrickCache::Round frameRound() const { return frameRound_; }  // the first of the frame
  BrickCache::Round nextReplaced() const { return cache_.oldest(); }

  std::size_t uploaded() const { return uploaded_; }  // in this frame
  std::size_t evicted() const { return evicted_; }
  double uploadMilliseconds() const { return uploadMilliseconds_; }  // wall time

 private:
  glm::ivec3 brickAt(BrickCache::Brick brick) const;
  enum class Entry { absent, resident, lost, partlyLost };  // bricks.glsl holds the same numbers
  void setEntry(BrickCache::Brick brick, Entry entry) const;
  BlockBits fetch(BrickCache::Brick brick);           // its texels; what of it is lost
  BlockBits blocksOf(BrickCache::Brick brick) const;  // that hold cells of the volume
  void upload(BrickCache::Brick brick, BrickCache::Slot slot);

  GlPtr gl_;
  std::vector<const TexelSource*> channels_;
  int apron_;
  Moved moved_;
  glm::ivec3 dims_, slotDims_;
  BrickCache cache_;
  std::vector<Texture> caches_;
  bool hasBlockBits_;  // the table has a second half: of each brick which blocks are lost
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
