#include "ui/viewport/shared_context.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "base/error.h"

namespace isolux::ui {

namespace {

[[noreturn]] void fail(const char* reason) {
  throw base::Error(base::ErrorKind::graphics, "", "OpenGL", reason);
}

class SharedContext final : public render::OffscreenContext {
 public:
  explicit SharedContext(std::shared_ptr<QOffscreenSurface> surface) : surface_(std::move(surface)) {
    QOpenGLContext* const window = QOpenGLContext::globalShareContext();
    context_.setFormat(window->format());
    context_.setShareContext(window);
    if (!context_.create()) fail("the window system creates no second context");
    if (!QOpenGLContext::areSharing(&context_, window)) fail("the driver shares no objects between contexts");
    SharedContext::makeCurrent();
    load("Qt " + QGuiApplication::platformName().toStdString() + ", shared with the window",
         [this](const char* name) { return reinterpret_cast<void*>(context_.getProcAddress(name)); });
  }
  ~SharedContext() override { context_.doneCurrent(); }
  void makeCurrent() override {
    if (!context_.makeCurrent(surface_.get())) fail("the window system cannot make the context current");
  }

 private:
  std::shared_ptr<QOffscreenSurface> surface_;
  QOpenGLContext context_;
};

}  // namespace

std::function<std::unique_ptr<render::OffscreenContext>()> sharedContext() {
  // Made, used and destroyed by different threads; windows belong to that of the application.
  const std::shared_ptr<QOffscreenSurface> surface(new QOffscreenSurface,
                                                   [](QOffscreenSurface* made) { made->deleteLater(); });
  surface->setFormat(QOpenGLContext::globalShareContext()->format());
  surface->create();
  return [surface] { return std::make_unique<SharedContext>(surface); };
}

}  // namespace isolux::ui
