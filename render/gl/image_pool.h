// The images that passes draw into, by their names (render/graph/pass.h): made when first asked for, kept
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
  // Beyond it, the images are known to hold what stands for nothing; of new ones nothing is known.
  volume::PictureArea drawn;
  std::size_t bytes() const;
};

class ImagePool {
 public:
  // The target of this name, made (anew) where there is none of this size and these formats.
  // Throws base::Error{memory, graphics}.
  Target& make(const GlPtr& gl, const std::string& name, glm::ivec2 size, const std::vector<GLenum>& formats);
  // What make() has made. Throws std::logic_error where it has not.
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
