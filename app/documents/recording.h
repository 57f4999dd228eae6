// Recordings: JSON Lines of Scene diffs with times.
//
// Line 1: {"isolux_recording": 6, "program": "...", "scene": {...}} - the scene at time 0. Each further line:
// {"time": seconds, "name": "Rotate", "set": {"camera.eye": [...], ...}}, times not decreasing. Paths
// are stored as in sessions (app/documents/stored_scene.h).
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/rules/flow_clock.h"
#include "scene/settings/scene_diff.h"

namespace isolux::app {

// Throws Error{input} when `file` holds something that is no recording: it is not written over.
void checkMayRecordInto(const std::filesystem::path& file);

class Recorder {
 public:
  // Starts the file at once, in place of an older recording; each add() is flushed: a crash loses nothing.
  // All throw Error{input}, also when the disk is full.
  Recorder(const std::filesystem::path& file, const scene::Scene& start);
  void add(const scene::SceneDiff& diff);                  // at the time since the start
  void add(const scene::SceneDiff& diff, double seconds);  // at a given time (tests)

 private:
  void write(const std::string& text);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::chrono::steady_clock::time_point begin_;
};

struct Recording {
  scene::Scene start;
  struct Step {
    double seconds;
    scene::SceneDiff diff;
  };
  std::vector<Step> steps;
  std::vector<std::string> warnings;  // a last line that was cut short
  double duration() const { return steps.empty() ? 0.0 : steps.back().seconds; }
};
// The scene as the window showed it then: an animated flow has moved on. Times do not decrease, as of the
// frames of a movie: each step is applied once. The recording must live as long.
class Playback {
 public:
  explicit Playback(const Recording& recording);
  const scene::Scene& at(double seconds);

 private:
  const Recording& recording_;
  scene::Scene scene_;  // with the flow's time of the recording
  scene::Scene shown_;  // with that of the clock
  scene::FlowClock clock_;
  std::size_t next_ = 0;  // step
  double now_ = 0.0;      // seconds
};
// Error{input} with the line number. A last line that was cut short, as a crash or a full disk leaves it, is
// left out.
Recording loadRecording(const std::filesystem::path& file);

// True for files that loadRecording() should be tried on (by content).
bool isRecording(const std::filesystem::path& file);

}  // namespace isolux::app
