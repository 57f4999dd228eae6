// Stores the images that passes draw into, by name (render/graph/pass.h): created when first requested, kept
// until they are freed. A new image takes the texture of a freed one of its format and size, if there is one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "render/gl/gl_objects.h"
#include "volume/cast/picture_area.h"

namespace isolux::render {

// Images of one size and the framebuffer that draws into all of them.
struct Target {
  std::vector<Texture> images;
  Framebuffer framebuffer;
  // Outside this area, the images hold the value for pixels without content. For new images the area is
  // unknown.
  volume::PictureArea drawn;
  std::size_t bytes() const;
};

class ImagePool {
 public:
  // Returns the target of this name; creates it if none of this size and these formats exists. Throws
  // base::Error{memory, graphics}.
  Target& make(const GlPtr& gl, const std::string& name, glm::ivec2 size, const std::vector<GLenum>& formats);
  // Returns a target that make() created. Throws std::logic_error if it does not exist.
  const Target& at(const std::string& name) const;
  Target& at(const std::string& name);
  bool has(const std::string& name) const { return entries_.count(name) > 0; }

  // Frees a target, if it exists. Its textures stay for the next make() until the next dropFree().
  void drop(const std::string& name);
  // Frees the targets whose names end so.
  void dropEnding(const std::string& ending);
  void dropFree() { free_.clear(); }
  void clear() {
    entries_.clear();
    free_.clear();
  }
  std::size_t bytesOf(const std::string& name) const;
  std::size_t bytes() const;  // of all textures
  // Returns the most bytes() since the last beginPeak().
  std::size_t peakBytes() const { return peak_; }
  void beginPeak() { peak_ = bytes(); }

 private:
  struct Entry {
    glm::ivec2 size;
    std::vector<GLenum> formats;
    Target target;
  };
  struct FreeTexture {
    GLenum format;
    Texture texture;
  };
  std::vector<Texture> texturesOf(const GlPtr& gl, glm::ivec2 size, const std::vector<GLenum>& formats);
  std::map<std::string, Entry> entries_;
  std::vector<FreeTexture> free_;
  std::size_t peak_ = 0;
};

}  // namespace isolux::render
