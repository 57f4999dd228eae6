// Shows pictures that stay on the graphics card (QOpenGLWidget). Its context shares objects with that of the
// picture thread, through Qt's global share context.
#pragma once

#include <optional>

#include <QOpenGLWidget>

#include "render/gl/gl_objects.h"
#include "ui/viewport/canvas.h"

namespace isolux::ui {

class TextureCanvas : public QOpenGLWidget, public Canvas {
  Q_OBJECT
 public:
  TextureCanvas(QWidget* parent, Painted painted);
  ~TextureCanvas() override;
  QWidget* widget() override { return this; }
  CanvasKind kind() const override { return CanvasKind::textures; }
  QImage read(const CanvasPicture& picture) override;

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  // Holds the objects of one context; the window system may replace the context.
  struct Objects {
    explicit Objects(render::GlPtr pointer);
    render::GlPtr gl;
    render::Program program;
    render::VertexArray empty;
    render::Texture over;
    qint64 overKey = 0;  // QImage::cacheKey of what `over` holds
  };
  void release();
  void draw(const CanvasContent& shown);
  GLuint overTexture(const QImage& over);
  std::optional<Objects> objects_;
};

}  // namespace isolux::ui
