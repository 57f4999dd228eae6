// What a saved or copied picture carries, its size and background, with a preview.
//
// Values in, values out: who shows it applies them and asks for the file.
#pragma once

#include <functional>

#include <QDialog>
#include <QImage>

#include "scene/scene.h"
#include "ui/document/picture_request.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace isolux::ui {

struct PictureChoices {
  PictureRequest request;
  scene::Picture picture;  // letters, scaleBar, isovalue, caveats, transparent count
  bool legend = true;      // look.legend
};

class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  // `window`: pixels of the picture on screen. `hasLegend`: the look has one to draw.
  PictureDialog(const PictureChoices& choices, QSize window, bool hasLegend, QWidget* parent = nullptr);

  PictureChoices choices() const;
  // What `draw` makes of the choices is shown beside them.
  using Draw = std::function<QImage(const PictureChoices& choices)>;
  void setPreview(Draw draw);

  QCheckBox *letters, *scaleBar, *isovalue, *caveats, *legend, *transparent, *session, *fullPaths;
  QComboBox* size;
  QSpinBox *width, *height;  // of a size of one's own
  QPushButton *save, *copy;
  QLabel* preview;

 Q_SIGNALS:
  void saveAsked(const isolux::ui::PictureChoices& choices);
  void copyAsked(const isolux::ui::PictureChoices& choices);

 private:
  void showChoices();  // what depends on the choices
  void answer(void (PictureDialog::*asked)(const PictureChoices&));

  PictureChoices given_;
  QSize window_;
  Draw draw_;
};

}  // namespace isolux::ui
