// Where an animated flow stands: flow.time of the scene plus the seconds it has run since.
//
// The window and replay count with the same clock, so that both show the same picture at the same moment.
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

class FlowClock {
 public:
  explicit FlowClock(const Scene& scene) { setScene(scene); }

  // A flow.time that was set, or a flow that does not run, is taken as it is; else the clock goes on.
  void setScene(const Scene& scene);
  void advance(double seconds);  // >= 0; nothing while the flow does not run

  bool runs() const { return runs_; }  // flow.animate is on and streaks are drawn
  double seconds() const;              // in the range of flow.time; starts again at 0 behind its end

 private:
  bool runs_ = false;
  double base_ = 0.0, elapsed_ = 0.0;  // seconds
};

}  // namespace isolux::scene
