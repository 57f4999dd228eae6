// Computes the time of an animated flow: flow.time of the scene plus the seconds it has run since.
//
// The window and replay use the same clock, so that both show the same image at the same time.
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

class FlowClock {
 public:
  explicit FlowClock(const Scene& scene) { setScene(scene); }

  // Sets the scene. If flow.time has changed, or the flow does not run, the clock starts at flow.time; else
  // it continues.
  void setScene(const Scene& scene);
  void advance(double seconds);  // requires >= 0; no effect while the flow does not run

  bool runs() const { return runs_; }  // flow.animate is on and streaks are drawn
  double seconds() const;              // in the range of flow.time; restarts at 0 after its end

 private:
  bool runs_ = false;
  double base_ = 0.0, elapsed_ = 0.0;  // seconds
};

}  // namespace isolux::scene
