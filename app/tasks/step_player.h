// Plays the time steps of a volume: loads those that come on a thread and says which one to show.
//
// Between two steps blends are shown where the speed leaves time for them. A step that is not loaded when its
// time has come is left out: the speed holds, the picture before it stays. Steps that were shown are kept for
// the next round while memory allows. Lives on the owner's thread, which never waits.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "app/tasks/load_task.h"

namespace isolux::app {

class StepPlayer {
 public:
  struct Step {
    scene::Source source;
    std::shared_ptr<const volume::PreparedVolume> volume;
  };

  // Starts at `shown`, after the last step from the first one again. The volume has several steps; speed in
  // steps per second.
  StepPlayer(Step shown, double speed);

  // Called again and again with the seconds since the start, which grow: the step to show, if it is another
  // one than before.
  std::optional<Step> at(double seconds);
  // Why a step could not be loaded; nothing more is to be expected then.
  const std::optional<base::Error>& error() const { return error_; }

  static int blendsOf(double speed);  // pictures for each step

 private:
  using Frame = long long;  // since the first frame of the first round
  int inRound(Frame frame) const { return static_cast<int>(frame % round_); }
  void collect(double seconds);
  bool showNewest(Frame now);
  void loadNext(Frame now, double seconds);
  bool makeRoom(Frame now, Frame next);

  Step last_;  // that was shown
  int blends_, round_;
  double framesPerSecond_;
  Frame first_, shown_;
  std::map<int, std::shared_ptr<const volume::PreparedVolume>> ready_;  // by their place in the round
  std::unique_ptr<LoadTask> task_;
  int loading_ = 0;  // of task_
  double began_ = 0.0, loadSeconds_ = 0.0;
  std::optional<base::Error> error_;
};

}  // namespace isolux::app
