#include "render/gl/image_pool.h"

#include <algorithm>
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
  target.images = texturesOf(gl, size, formats);
  for (const Texture& image : target.images) colors.push_back(&image);
  target.framebuffer = Framebuffer(gl, colors);
  target.drawn = volume::PictureArea::whole(size);
  Target& made = entries_.emplace(name, Entry{size, formats, std::move(target)}).first->second.target;
  peak_ = std::max(peak_, bytes());
  return made;
}

std::vector<Texture> ImagePool::texturesOf(const GlPtr& gl, glm::ivec2 size,
                                           const std::vector<GLenum>& formats) {
  std::vector<Texture> textures(formats.size());
  bool all = true;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const auto fits = std::find_if(free_.begin(), free_.end(), [&](const FreeTexture& one) {
      return one.format == formats[i] && one.texture.size() == glm::ivec3(size, 1);
    });
    all = all && fits != free_.end();
    if (fits == free_.end()) continue;
    textures[i] = std::move(fits->texture);
    textures[i].setFilter(GL_NEAREST);
    free_.erase(fits);
  }
  if (all) return textures;
  free_.clear();  // before others are made: both need not fit
  for (std::size_t i = 0; i < formats.size(); ++i)
    if (!textures[i]) textures[i] = Texture::make2D(gl, formats[i], size);
  return textures;
}

void ImagePool::drop(const std::string& name) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return;
  Entry& entry = found->second;
  for (std::size_t i = 0; i < entry.formats.size(); ++i)
    free_.push_back({entry.formats[i], std::move(entry.target.images[i])});
  entries_.erase(found);
}

void ImagePool::dropEnding(const std::string& ending) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_)
    if (name.ends_with(ending)) names.push_back(name);
  for (const std::string& name : names) drop(name);
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
  for (const FreeTexture& one : free_) sum += one.texture.bytes();
  return sum;
}

}  // namespace isolux::render
