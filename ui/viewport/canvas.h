// Shows the viewport's picture: in pixels, which Qt's raster engine paints, or in textures, which never leave
// the graphics card. Both show the same pixels; letters, handles and marks lie over either.
#pragma once

#include <functional>
#include <memory>

#include <QImage>
#include <QWidget>

#include "render/gl/handed_picture.h"

namespace isolux::ui {

// A picture as the picture thread returns it: pixels (Format_RGB32), or a texture.
struct CanvasPicture {
  QImage pixels;
  std::shared_ptr<const render::HandedPicture> texture;

  explicit operator bool() const { return texture || !pixels.isNull(); }
  QSize size() const { return texture ? QSize(texture->size().x, texture->size().y) : pixels.size(); }
};

struct CanvasContent {
  CanvasPicture picture;       // none: the plain ground
  QImage over;                 // shown in its place, if there is one
  CanvasPicture before;        // fades into it
  double opacityBefore = 0.0;  // 0 to 1
};

enum class CanvasKind { pixels, textures };

class Canvas {
 public:
  // Called after each painting.
  using Painted = std::function<void()>;
  explicit Canvas(Painted painted) : painted_(std::move(painted)) {}
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  virtual QWidget* widget() = 0;
  virtual CanvasKind kind() const = 0;
  // Returns the pixels of a picture of this canvas's kind. Reads a texture back from the card.
  virtual QImage read(const CanvasPicture& picture) = 0;

  void show(CanvasContent content) {
    content_ = std::move(content);
    widget()->update();
  }
  const CanvasContent& content() const { return content_; }

 protected:
  void painted() const { painted_(); }

 private:
  CanvasContent content_;
  Painted painted_;
};

std::unique_ptr<Canvas> makeCanvas(CanvasKind kind, QWidget* parent, Canvas::Painted painted);

inline constexpr float canvasGround[3] = {0.09F, 0.10F, 0.12F};  // without a picture, sRGB

}  // namespace isolux::ui
