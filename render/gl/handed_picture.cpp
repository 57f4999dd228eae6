#include "render/gl/handed_picture.h"

#include <algorithm>
#include <utility>

namespace isolux::render {

// `read` is written by the holder of the picture while it is out, by the ring otherwise.
struct HandedPicture::Slot {
  Texture texture;
  GLsync drawn = nullptr, read = nullptr;
  std::atomic<bool> out{false};
};

namespace {

std::atomic<std::size_t> livingTextures{0};

void replaceFence(const Gl& gl, GLsync& fence) {
  if (fence) gl.DeleteSync(fence);
  fence = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.Flush();  // or another context might wait for a fence that was never submitted
}

}  // namespace

HandedPicture::HandedPicture(std::shared_ptr<Slot> slot, GLuint texture, glm::ivec2 size)
    : slot_(std::move(slot)), texture_(texture), size_(size) {}

HandedPicture::~HandedPicture() {
  slot_->out.store(false, std::memory_order_release);
}

void HandedPicture::await(const Gl& gl) const {
  gl.WaitSync(slot_->drawn, 0, GL_TIMEOUT_IGNORED);
}

void HandedPicture::readUntilHere(const Gl& gl) const {
  replaceFence(gl, slot_->read);
}

PictureRing::PictureRing(GlPtr gl) : gl_(std::move(gl)) {}

PictureRing::~PictureRing() {
  for (const auto& slot : slots_) destroy(*slot);
}

void PictureRing::destroy(HandedPicture::Slot& slot) const {
  for (GLsync* const fence : {&slot.drawn, &slot.read})
    if (*fence) gl_->DeleteSync(std::exchange(*fence, nullptr));
  slot.texture = {};
  --livingTextures;
}

const std::shared_ptr<HandedPicture::Slot>& PictureRing::freeSlot(glm::ivec2 size) {
  const auto isFree = [](const auto& slot) { return !slot->out.load(std::memory_order_acquire); };
  std::erase_if(slots_, [&](const auto& slot) {
    if (!isFree(slot) || glm::ivec2(slot->texture.size()) == size) return false;
    destroy(*slot);
    return true;
  });
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const auto& slot) {
    return isFree(slot) && glm::ivec2(slot->texture.size()) == size;
  });
  if (found != slots_.end()) return *found;
  auto slot = std::make_shared<HandedPicture::Slot>();
  slot->texture = Texture::make2D(gl_, GL_RGBA8, size);
  slot->texture.setFilter(GL_LINEAR);
  ++livingTextures;
  return slots_.emplace_back(std::move(slot));
}

std::shared_ptr<const HandedPicture> PictureRing::hand(const Texture& picture) {
  const glm::ivec2 size(picture.size());
  const std::shared_ptr<HandedPicture::Slot>& slot = freeSlot(size);
  if (slot->read) gl_->WaitSync(slot->read, 0, GL_TIMEOUT_IGNORED);
  gl_->CopyImageSubData(picture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, slot->texture.id(), GL_TEXTURE_2D, 0, 0, 0,
                        0, size.x, size.y, 1);
  replaceFence(*gl_, slot->drawn);
  slot->out.store(true, std::memory_order_relaxed);
  return std::shared_ptr<const HandedPicture>(new HandedPicture(slot, slot->texture.id(), size));
}

std::size_t PictureRing::textures() {
  return livingTextures.load();
}

}  // namespace isolux::render
