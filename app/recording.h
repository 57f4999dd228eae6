// Recordings: JSON Lines of Scene diffs with times.
//
// Line 1: {"isolux_recording": 1, "program": "...", "scene": {...}} - the scene at time 0. Each further line:
// {"time": seconds, "name": "Rotate", "set": {"camera.eye": [...], ...}}, times not decreasing. source.path
// is stored as in sessions (app/stored_scene.h).
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include "scene/settings.h"

namespace isolux::app {

class Recorder {
 public:
  // Starts the file at once, each add() is flushed: a crash loses nothing. Throws Error{input}.
  Recorder(const std::filesystem::path& file, const scene::Scene& start);
  void add(const scene::SceneDiff& diff);                  // at the time since the start
  void add(const scene::SceneDiff& diff, double seconds);  // at a given time (tests)

 private:
  std::ofstream stream_;
  std::filesystem::path folder_;  // of the file: source.path is stored relative to it
  std::chrono::steady_clock::time_point begin_;
};

struct Recording {
  scene::Scene start;
  struct Step {
    double seconds;
    scene::SceneDiff diff;
  };
  std::vector<Step> steps;
  double duration() const { return steps.empty() ? 0.0 : steps.back().seconds; }
  // As the window showed it then: an animated flow has moved on.
  scene::Scene sceneAt(double seconds) const;
};
Recording loadRecording(const std::filesystem::path& file);  // Error{input} with the line number

}  // namespace isolux::app
