// Chooses how the window shows pictures: as textures that stay on the graphics card, or as pixels.
//
// window.canvas decides. auto: textures if the window system offers OpenGL 4.5 of a graphics card; pixels if
// it offers none; where it is software, whichever a measurement of a few milliseconds finds quicker. That
// choice is stored for a week, so that later starts create no OpenGL context for it, unless the display, its
// devices or the drivers' variables change.
#pragma once

#include <functional>
#include <memory>

#include <QString>

#include "render/gl/gl_context.h"
#include "scene/settings/host_settings.h"
#include "ui/viewport/canvas.h"

namespace isolux::ui {

struct CanvasChoice {
  CanvasKind kind = CanvasKind::pixels;
  QString why;
  // Creates the context of the picture thread, on that thread; empty: a context without a window.
  std::function<std::unique_ptr<render::OffscreenContext>()> context{};
};

// Asks Qt for contexts that share objects, unless none will be needed. Call it before QApplication exists.
void prepareCanvas(scene::Canvas request);
// Call it on the window's thread.
CanvasChoice chooseCanvas(scene::Canvas request);
// Returns the choice in a line.
QString describe(const CanvasChoice& choice);

}  // namespace isolux::ui
