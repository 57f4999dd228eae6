// How pictures are saved and copied, kept for this user between runs: their size, what they carry, and what
// is written on those of a new document.
#pragma once

#include <QSize>

#include "scene/scene.h"

namespace isolux::ui {

struct PictureRequest {
  double factor = 1.0;  // pixels per pixel of the window; 0: `size`
  QSize size{1920, 1080};
  bool session = true;     // PNG and EXR carry it
  bool fullPaths = false;  // it names the folders of its files
  bool operator==(const PictureRequest&) const = default;

  // Of a window's picture of that many pixels of the screen: at most 16384 along a side.
  QSize pixels(QSize window) const;
  // Pixels of the picture per pixel that settings mean, where the screen has `screenRatio` of them.
  double pixelRatio(QSize window, double screenRatio) const;
};
PictureRequest savedPictureRequest();
void savePictureRequest(const PictureRequest& request);

// What is written on pictures of a document that does not say so: letters, scale bar and isovalue at first,
// then as chosen last.
scene::Picture withKeptWords(scene::Picture picture);
void keepWords(const scene::Picture& picture);
// `picture` with what is written on `chosen`, and its background.
scene::Picture withWordsOf(const scene::Picture& chosen, scene::Picture picture);
// As the window draws it, which writes letters and lengths over its picture by itself and has a background.
scene::Picture asInWindow(scene::Picture picture);

}  // namespace isolux::ui
