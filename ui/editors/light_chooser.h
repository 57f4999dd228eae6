// The built-in lights as thumbnails in a row: a click takes one.
#pragma once

#include <vector>

#include <QToolButton>

#include "ui/document/edit.h"

namespace isolux::ui {

class LightChooser : public QWidget {
  Q_OBJECT
 public:
  explicit LightChooser(QWidget* parent = nullptr);

  void setScene(const scene::Scene& scene);
  QToolButton* button(scene::BuiltInLight light) const { return buttons_[static_cast<std::size_t>(light)]; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);

 protected:
  void showEvent(QShowEvent* event) override;  // the thumbnails are drawn when they are first seen

 private:
  void drawNext();

  scene::Scene scene_;
  std::vector<QToolButton*> buttons_;  // in the order of the lights
  std::size_t drawn_ = 0;              // of the buttons, how many have their picture
};

}  // namespace isolux::ui
