// A button that shows a colour and lets the user choose another. Colours are linear RGB, as in the Scene.
#pragma once

#include <QToolButton>

#include <glm/vec3.hpp>

namespace isolux::ui {

// Linear RGB (ITU-R BT.709) to what the screen shows (sRGB transfer curve, IEC 61966-2-1), and back.
QColor screenColour(glm::dvec3 linear);
glm::dvec3 linearColour(const QColor& screen);

class ColorButton : public QToolButton {
  Q_OBJECT
 public:
  explicit ColorButton(QWidget* parent = nullptr);
  void showColour(glm::dvec3 linear);
  glm::dvec3 colour() const { return colour_; }

 Q_SIGNALS:
  void chosen(glm::dvec3 linear);  // while the dialog is open: every colour that is tried

 private:
  void choose();
  glm::dvec3 colour_{0.5};  // until one is shown
};

}  // namespace isolux::ui
