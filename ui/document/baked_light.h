// The light of the document's scene for the window: owns the app::LightController, tells it what is shown and
// seen, and polls it.
//
// Lives on the GUI thread; nothing runs on a foreign thread. Pictures are asked for no more often than they
// leave most of the time to the bake. They are lit by stored light only when that makes them better: from
// when all that is seen is lit without coarse noise, until a quarter of what is seen is not, in another view
// or of another surface. What takes long begins only when a user has asked for light, not when a preset has.
// Its end stops the bake: at most 100 ms.
#pragma once

#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/light/light_controller.h"
#include "ui/document/document.h"

namespace isolux::ui {

using LightPointer = std::shared_ptr<const gi::PictureLight>;

class BakedLight : public QObject {
  Q_OBJECT
 public:
  explicit BakedLight(QObject* parent = nullptr);

  void setVolume(VolumePointer volume);  // its light is gone at once; setScene() follows
  void setScene(const scene::Scene& resolved);
  // The surface points of the picture. `finer`: of the same view as the last, with more pixels.
  void setVisible(gi::VisiblePointSet hitVoxels, bool finer);
  // scene::HostSettings::threads.
  void setThreads(std::optional<int> threads) { controller_.setThreads(threads); }
  // A frame is drawn now: the processor is needed.
  void setDrawing(bool drawing) { controller_.yield(drawing); }
  void setDrawn(double milliseconds) { drawMilliseconds_ = milliseconds; }

  const app::LightState& state() const { return state_; }
  const LightPointer& light() const { return light_; }
  // Pictures may be lit by it; else by lights that need not be stored (scene::withoutGi).
  bool isShown() const { return shown_; }
  // The light has not changed for good: more is on its way without anyone doing anything.
  bool changing() const;
  bool cancelled() const { return cancelled_; }

  void setPaused(bool paused);
  void cancel();  // keeps what there is
  void goOn();    // after setPaused(true) or cancel(), or takesLong()
  // Nobody has asked for the light of this scene by itself: it is paused if it is going to take long.
  void askFirst();

 Q_SIGNALS:
  // Another picture would show other light, or the light will not change any more. `shown`: isShown().
  void lightChanged(const isolux::ui::LightPointer& light, bool changing, bool shown);
  void takesLong(double seconds);  // it was paused: askFirst()
  void answered();                 // it goes on, or no look needs it any more
  void stateChanged(const isolux::app::LightState& state, bool cancelled);
  void failed(const QString& message);
  void noted(const QString& message);

 private:
  void poll();
  void takeState();
  void considerShowing();
  void considerAsking();
  void tellProblems();
  double pauseBetweenPictures() const;  // milliseconds

  app::LightController controller_;
  app::LightState state_;
  VolumePointer volume_;
  scene::Scene scene_;
  gi::VisiblePointSet hits_;
  LightPointer light_;
  std::uint64_t revision_ = 0;
  bool toldScene_ = false;
  bool asked_ = false;        // of another scene or view than state_ knows of
  bool volumeIsNew_ = false;  // the controller may still have the light of the one before
  bool cancelled_ = false;
  bool wasChanging_ = false;
  bool shown_ = false, wasShown_ = false;
  bool otherSurface_ =
      false;  // another view, or another surface, of which it is not known yet how much is lit
  bool asksFirst_ = false, held_ = false;  // askFirst(); and it was paused therefore
  double drawMilliseconds_ = 0.0;
  QString problem_, warnings_;  // told already
  QTimer timer_;
  QElapsedTimer sincePicture_, sinceState_;
};

}  // namespace isolux::ui
