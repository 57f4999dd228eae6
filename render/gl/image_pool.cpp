#include "render/gl/image_pool.h"

#include <stdexcept>
#include <utility>

namespace isolux::render {

std::size_t Target::bytes() const {
  std::size_t sum = 0;
  for (const Texture& image : images) sum += image.bytes();
  return sum;
}

Target& ImagePool::make(const GlPtr& gl, const std::string& name, glm::ivec2 size,
                        const std::vector<GLenum>& formats) {
  const auto found = entries_.find(name);
  if (found != entries_.end()) {
    if (found->second.size == size && found->second.formats == formats) return found->second.target;
    entries_.erase(found);  // before its successor is made: both need not fit
  }
  Target target;
  std::vector<const Texture*> colors;
  for (const GLenum format : formats) target.images.push_back(Texture::make2D(gl, format, size));
  for (const Texture& image : target.images) colors.push_back(&image);
  target.framebuffer = Framebuffer(gl, colors);
  target.drawn = volume::PictureArea::whole(size);
  return entries_.emplace(name, Entry{size, formats, std::move(target)}).first->second.target;
}

const Target& ImagePool::at(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end())
    throw std::logic_error("images of " + name + " are read, but were never drawn");
  return found->second.target;
}

Target& ImagePool::at(const std::string& name) {
  return const_cast<Target&>(std::as_const(*this).at(name));
}

std::size_t ImagePool::bytesOf(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? 0 : found->second.target.bytes();
}

std::size_t ImagePool::bytes() const {
  std::size_t sum = 0;
  for (const auto& [key, entry] : entries_) sum += entry.target.bytes();
  return sum;
}

}  // namespace isolux::render
