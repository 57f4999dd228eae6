// Stores the images that passes draw into, by name (render/graph/pass.h): created when first requested, kept
// between frames.
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

  void drop(const std::string& name) { entries_.erase(name); }
  void clear() { entries_.clear(); }
  std::size_t bytesOf(const std::string& name) const;
  std::size_t bytes() const;

 private:
  struct Entry {
    glm::ivec2 size;
    std::vector<GLenum> formats;
    Target target;
  };
  std::map<std::string, Entry> entries_;
};

}  // namespace isolux::render
