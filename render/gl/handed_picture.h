// Hands finished pictures from the context that draws them to another context of its share group, without a
// copy through main memory.
//
// The writer copies a picture into a texture of its ring and sets a fence behind the copy; the reader waits
// for that fence before it reads, and sets one of its own behind its last read, for which the writer waits
// before it writes there again. Both wait on the GPU (glWaitSync): no thread does.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "render/gl/gl_objects.h"

namespace isolux::render {

// A picture in a texture of a ring: RGBA8, bottom row first. Its destruction returns the texture to the ring
// and needs no context. Valid while the ring exists; the ring may be destroyed first.
class HandedPicture {
 public:
  HandedPicture(const HandedPicture&) = delete;
  HandedPicture& operator=(const HandedPicture&) = delete;
  ~HandedPicture();

  GLuint texture() const { return texture_; }
  glm::ivec2 size() const { return size_; }
  // Lets the later commands of the current context read the finished picture. Call it before each use.
  void await(const Gl& gl) const;
  // Declares that the commands of the current context so far may read the picture. Call it after each use.
  void readUntilHere(const Gl& gl) const;

 private:
  friend class PictureRing;
  struct Slot;
  HandedPicture(std::shared_ptr<Slot> slot, GLuint texture, glm::ivec2 size);
  std::shared_ptr<Slot> slot_;
  GLuint texture_;
  glm::ivec2 size_;
};

// The textures of one writer. As many are created as are out at the same time; those of another size are
// deleted when they come back. All members require the writer's context to be current.
class PictureRing {
 public:
  explicit PictureRing(GlPtr gl);
  ~PictureRing();
  PictureRing(const PictureRing&) = delete;
  PictureRing& operator=(const PictureRing&) = delete;

  // Copies an RGBA8 image. Throws base::Error{memory, graphics}.
  std::shared_ptr<const HandedPicture> hand(const Texture& picture);

  // Returns the number of textures of all rings of the process, for tests.
  static std::size_t textures();

 private:
  const std::shared_ptr<HandedPicture::Slot>& freeSlot(glm::ivec2 size);
  void destroy(HandedPicture::Slot& slot) const;
  GlPtr gl_;
  std::vector<std::shared_ptr<HandedPicture::Slot>> slots_;
};

}  // namespace isolux::render
