// Pictures that are handed over: what is read is what was drawn, and textures come back to their ring.
#include "render/gl/handed_picture.h"

#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "render/gl/gl_context.h"

namespace isolux::test {
namespace {

using render::HandedPicture;
using render::PictureRing;
using render::Texture;

class HandedPictureGlTest : public testing::Test {
 protected:
  void SetUp() override {
    context_ = render::OffscreenContext::create(render::ContextChoice::software);
    gl_ = context_->gl();
    ring_.emplace(gl_);
  }
  // An image of one byte repeated.
  Texture filled(glm::ivec2 size, std::uint8_t value) const {
    Texture texture = Texture::make2D(gl_, GL_RGBA8, size);
    const std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size.x * size.y) * 4, value);
    gl_->TextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return texture;
  }
  int valueOf(const HandedPicture& picture) const {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(picture.size().x * picture.size().y) * 4);
    picture.await(*gl_);
    gl_->GetTextureImage(picture.texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()),
                         bytes.data());
    picture.readUntilHere(*gl_);
    return bytes == std::vector<std::uint8_t>(bytes.size(), bytes[0]) ? bytes[0] : -1;
  }

  std::unique_ptr<render::OffscreenContext> context_;
  render::GlPtr gl_;
  std::optional<PictureRing> ring_;
};

TEST_F(HandedPictureGlTest, APictureThatIsOutIsNotDrawnOver) {
  const auto first = ring_->hand(filled({16, 8}, 10));
  const auto second = ring_->hand(filled({16, 8}, 20));
  EXPECT_EQ(valueOf(*first), 10);
  EXPECT_EQ(valueOf(*second), 20);
  EXPECT_EQ(first->size(), glm::ivec2(16, 8));
  EXPECT_EQ(PictureRing::textures(), 2u);
}

TEST_F(HandedPictureGlTest, ATextureThatCameBackIsUsedAgain) {
  auto first = ring_->hand(filled({16, 8}, 10));
  EXPECT_EQ(valueOf(*first), 10);
  const GLuint texture = first->texture();
  first.reset();
  for (int value = 1; value < 50; ++value) {
    const auto next = ring_->hand(filled({16, 8}, static_cast<std::uint8_t>(value)));
    EXPECT_EQ(next->texture(), texture);
    EXPECT_EQ(valueOf(*next), value);
  }
  EXPECT_EQ(PictureRing::textures(), 1u);
}

TEST_F(HandedPictureGlTest, TexturesOfAnotherSizeGoWhenTheyComeBack) {
  auto small = ring_->hand(filled({8, 8}, 1));
  const auto large = ring_->hand(filled({32, 8}, 2));
  EXPECT_EQ(valueOf(*small), 1);
  EXPECT_EQ(PictureRing::textures(), 2u);
  small.reset();
  const auto next = ring_->hand(filled({32, 8}, 3));
  EXPECT_EQ(PictureRing::textures(), 2u);
  EXPECT_EQ(valueOf(*large), 2);
  EXPECT_EQ(valueOf(*next), 3);
}

TEST_F(HandedPictureGlTest, APictureMayOutliveItsRing) {
  const auto picture = ring_->hand(filled({8, 8}, 1));
  ring_.reset();
  EXPECT_EQ(PictureRing::textures(), 0u);
  context_.reset();
}  // the picture goes now, without a context

}  // namespace
}  // namespace isolux::test
