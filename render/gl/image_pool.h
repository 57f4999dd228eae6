// The images that passes draw into, by the name of the pass: made when first asked for, kept between frames.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "render/gl/gl_objects.h"

namespace isolux::render {

// Images of one size and the framebuffer that draws into all of them.
struct Target {
  std::vector<Texture> images;
  Framebuffer framebuffer;
  std::size_t bytes() const;
};

class ImagePool {
 public:
  // The target of `pass`, made (anew) where there is none of this size and these formats.
  // Throws base::Error{memory, graphics}.
  Target& make(const GlPtr& gl, const std::string& pass, glm::ivec2 size, const std::vector<GLenum>& formats);
  // What make() has made. Throws std::logic_error where it has not.
  const Target& at(const std::string& pass) const;
  bool has(const std::string& pass) const { return entries_.count(pass) > 0; }

  void drop(const std::string& pass) { entries_.erase(pass); }
  void clear() { entries_.clear(); }
  std::size_t bytesOf(const std::string& pass) const;
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
