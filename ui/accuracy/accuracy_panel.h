// What accuracy costs: error against time for each quality setting that acts in the scene, of the volume and
// view on show; how accurate the picture on screen is; and which settings keep an error or a time.
//
// Measured on background threads while the panel is seen and the window draws nothing, one at a time: a
// search that the user asked for, then the picture, then the quality settings. Dropped and begun anew when
// the view or the scene changes. With the panel closed nothing of it runs.
#pragma once

#include <map>
#include <string>

#include <QImage>
#include <QLabel>
#include <QTimer>

#include "app/study/study.h"
#include "ui/accuracy/picture_accuracy.h"
#include "ui/document/background_task.h"
#include "ui/document/baked_light.h"
#include "ui/panels/panel.h"

class QComboBox;

namespace isolux::ui {

class AccuracyChart;
class ErrorOverlayBox;
class TargetBox;

class AccuracyPanel : public Panel {
  Q_OBJECT
 public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  void setReport(const render::FrameReport& report, const render::FrameRequest& request) override;
  void setHostSettings(const scene::HostSettings& host);
  void setDrawing(bool draws);        // the window's own picture comes first
  void setComplete(bool complete);    // the picture on screen is the full one of the scene
  void setPreviewing(bool previews);  // the picture is not the document's
  // The pixels on screen and where their legend stands, after setComplete().
  void setPixels(std::function<QImage()> picture, const std::optional<render::Tile>& legend);
  void setLight(const LightPointer& light, bool changing);
  void seenChanged();  // its dock came to the front, or went

  QComboBox* qualityBox() const { return qualities_; }
  const AccuracyChart& chart() const { return *chart_; }
  QString state() const { return state_->text(); }
  bool complete() const;  // every quality setting that acts is measured, of the present scene
  bool working() const { return bool(task_); }
  bool waiting() const { return restTimer_.isActive(); }  // for the window to rest, to measure then
  int jobsBegun() const { return jobsBegun_; }
  const PictureAccuracy& picture() const { return *picture_; }
  ErrorOverlayBox* overlay() const { return overlay_; }

 Q_SIGNALS:
  // What is known of the picture on screen; empty: nothing, or nobody wants to know.
  void pictureKnown(const QString& text, const QString& meaning);
  // The picture on screen with its errors laid over; null: nothing is. `of`: whose pixels they are.
  void overlayPainted(const QImage& image, const QImage& of,
                      const std::optional<isolux::render::Tile>& legend);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Measured {
    app::QualityStudy study;
    scene::Scene of;  // what it was measured of, without what quality settings turn
  };
  void listQualities();
  std::vector<app::QualitySetting> missing() const;
  void measureSoon();
  void measure();
  void drop();
  void takeStudies(app::StudyTask& task);
  void showPicture();
  void tellPicture();
  void showTarget();
  void wantOverlay();
  void showOverlay();
  void showQuality();
  void showState();
  void choose(const QString& value);
  const app::QualitySetting* quality() const;  // the one in the box; null: none acts

  VolumePointer volume_;
  scene::Scene scene_, subject_;  // subject_: the scene without what quality settings turn
  scene::Scene resolved_;
  scene::HostSettings host_;
  LightPointer light_;
  struct Drawn {
    render::FrameRequest request;
    bool onProcessor = false;
  };
  Drawn reported_, drawn_;          // the last picture; the last full one
  std::function<QImage()> pixels_;  // of the last full one; empty: there is none
  std::optional<render::Tile> legend_;
  bool complete_ = false, previewing_ = false, lightChanging_ = false;
  std::vector<app::QualitySetting> acting_;
  std::map<std::string, Measured> measured_;  // by the quality setting's name
  BackgroundTask<void, std::vector<app::QualityStudy>> task_;
  QString trouble_;
  bool drawing_ = false;
  int jobsBegun_ = 0;
  QTimer restTimer_;

  PictureAccuracy* picture_;
  TargetBox* target_;
  ErrorOverlayBox* overlay_;
  QComboBox* qualities_;
  AccuracyChart* chart_;
  QLabel *state_, *meaning_, *key_;
};

}  // namespace isolux::ui
