// Ctrl-C at any moment of any long command, beside a busy process on each core: exit code 130, nothing half
// written, nobody left at work. How soon is printed, and judged by nobody but the reader: `./dev interrupts`
// makes the same with 100 moments a command, of which 95 should end within 100 ms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <csignal>

#include "app/documents/recording.h"
#include "app/files/image_io.h"
#include "app/light/light_controller.h"
#include "base/destroy_in_background.h"
#include "base/quantiles.h"
#include "scene/rules/automatic.h"
#include "scene/settings/scene_diff.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/busy_processes.h"
#include "tests/support/png_reader.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr int kMomentsOfTheSuite = 4;
constexpr double kLongestWait = 2.5;  // seconds after the start

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

int moments() {
  const char* const asked = std::getenv("ISOLUX_INTERRUPT_MOMENTS");
  return asked ? std::max(1, std::atoi(asked)) : kMomentsOfTheSuite;
}

// Names of unfinished files, in subfolders too.
Words partsIn(const fs::path& folder) {
  Words parts;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".part") parts.push_back(entry.path().string());
  return parts;
}

// Processes that work in this folder.
int processesIn(const fs::path& folder) {
  int count = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error)) {
    std::error_code gone;
    const fs::path here = fs::read_symlink(entry.path() / "cwd", gone);
    if (!gone && here == folder) ++count;
  }
  return count;
}

bool comesToRest(const fs::path& folder) {
  return test::pollUntil([&] { return processesIn(folder) == 0; });
}

double percentile(std::vector<double> values, double part) {
  return base::lowerQuantile(values, part);
}

class Interrupts : public ::testing::Test {
 protected:
  // Runs the command and interrupts it at random moments of its time.
  void interrupt(const Words& command, int number = SIGINT) {
    const auto begin = Clock::now();
    double longest = kLongestWait * 1000.0;
    {
      const BusyProcesses busy;
      RunningIsolux whole(command, {.folder = input_});
      if (test::pollUntil([&] { return processesIn(input_) == 0; }, kLongestWait))
        longest = std::min(longest, millisecondsSince(begin));
    }
    std::vector<double> times;
    for (int tries = 0; static_cast<int>(times.size()) < moments() && tries < 10 * moments(); ++tries) {
      const double after = std::uniform_real_distribution<double>(0.0, longest)(random_);
      if (const double time = interruptOnce(command, number, after); time >= 0.0)
        times.push_back(time);
      else
        longest = after;  // it is quicker now than it was
    }
    ASSERT_FALSE(times.empty());
    print(command.front(), times);
  }

  static void print(const std::string& what, const std::vector<double>& times) {
    std::printf("%-10s %3zu interrupts: median %5.1f ms, 95th percentile %5.1f ms, longest %5.1f ms\n",
                what.c_str(), times.size(), percentile(times, 0.5), percentile(times, 0.95),
                percentile(times, 1.0));
  }

  // Milliseconds from signal to end; negative: the command had finished before.
  double interruptOnce(const Words& command, int number, double after) {
    const fs::path folder = temporaryFolder();
    for (const auto& entry : fs::directory_iterator(input_))
      // The run that was measured may have been killed, and left its own part.
      if (entry.is_regular_file() && entry.path().extension() != ".part")
        fs::create_symlink(entry.path(), folder / entry.path().filename());
    const BusyProcesses busy;  // new ones each time: they live for a minute
    RunningIsolux running(command, {.folder = folder});
    // Before the supervisor stands, in the first part of a millisecond, the system itself ends it: nothing
    // has begun, and a shell calls that 130 for SIGINT, but not for the others.
    if (number != SIGINT) running.waitUntilItAnswers(number);
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(after));
    const bool answers = running.answers(number);
    const auto begin = Clock::now();
    running.signal(number);
    const RunResult result = running.wait();
    const double time = millisecondsSince(begin);
    EXPECT_THAT(partsIn(folder), testing::IsEmpty());
    EXPECT_TRUE(comesToRest(folder)) << "something goes on working";
    const bool finished = result.exitCode == 0;
    if (!finished) {
      EXPECT_EQ(result.exitCode, 130) << result.err;
      // Before the supervisor stands there is nobody to say it.
      if (answers) {
        EXPECT_EQ(result.err.substr(0, result.err.find('\n') + 1), "isolux: interrupted\n");
      }
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return finished ? -1.0 : time;
  }

  void writePhantom() {
    ASSERT_EQ(runIsolux({"phantom", "head", "--size", "160", "--out", "v.vti"}, {.folder = input_}).exitCode,
              0);
  }

  fs::path input_ = temporaryFolder();
  std::mt19937 random_{std::random_device()()};
};

TEST_F(Interrupts, EndRender) {
  interrupt({"render", "phantom:head:160", "--size", "1024x1024", "--out", "r.png"});
}

// Searches for settings draw, measure and bake beside one another.
TEST_F(Interrupts, EndSearchesForSettings) {
  interrupt({"render", "phantom:head:128", "--size", "800x600", "--error", "missed=0.1%", "--out", "r.png"});
  interrupt({"render", "phantom:head:64", "--size", "256x192", "--look", "gi", "--error", "light=3%", "--out",
             "r.png"});
}

TEST_F(Interrupts, EndBake) {
  interrupt({"bake", "phantom:head:96", "--out", "b.vti"});
}

TEST_F(Interrupts, EndStudy) {
  interrupt({"study", "phantom:head:64", "--size", "256x256", "--out", "s"});
}

TEST_F(Interrupts, EndReference) {
  interrupt({"reference", "phantom:head:96", "--size", "256x256", "--out", "r.exr"});
}

TEST_F(Interrupts, EndReplay) {
  scene::Scene scene;
  scene.source.path = "phantom:head:96";
  {
    app::Recorder recorder(input_ / "r.jsonl", scene);
    for (int i = 1; i < 100; ++i) {
      scene::Scene next = scene;
      next.camera.fov = 20.0 + 0.1 * i;
      recorder.add(scene::difference(scene, next, "Zoom"), 0.1 * i);
      scene = next;
    }
  }
  interrupt({"replay", "r.jsonl", "--size", "256x256", "--out", "frames"});
}

// What was drawn before Ctrl-C is there, whole; nothing else is.
TEST_F(Interrupts, KeepThePicturesOfASeriesThatWereFinished) {
  const std::vector<Words> series{{"--turntable", "500", "--out", "series"},
                                  {"--sweep", "isosurface.value=-0.5:0.5:500", "--out", "series/{i}.png"}};
  for (const Words& what : series) {
    const fs::path folder = temporaryFolder();
    fs::create_directory(folder / "series");
    Words command{"render", "phantom:ball:16", "--size", "64x48", "--set", "look.mode=depth"};
    command.insert(command.end(), what.begin(), what.end());
    RunningIsolux running(command, {.folder = folder});
    const auto drawn = [&] {
      Words pictures;
      for (const std::string& name : filesIn(folder / "series"))
        if (name.ends_with(".png")) pictures.push_back(name);
      return pictures;
    };
    ASSERT_TRUE(test::pollUntil([&] { return drawn().size() >= 3; })) << running.wait().err;
    running.signal(SIGINT);
    const RunResult result = running.wait();
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_THAT(partsIn(folder), testing::IsEmpty());
    const Words pictures = drawn();
    EXPECT_GE(pictures.size(), 3u);
    EXPECT_LT(pictures.size(), 500u);
    for (const std::string& name : pictures) {
      EXPECT_EQ(test::readPng(folder / "series" / name).size, glm::ivec2(64, 48)) << name;
      EXPECT_FALSE(app::readSessionText(folder / "series" / name).empty()) << "each can be drawn again";
    }
    EXPECT_THAT(filesIn(folder / "series"), testing::Not(testing::Contains("movie.mp4")));
  }
}

// A window that is closed, or that shows something else: its bake ends by itself, and is waited for here
// alone.
TEST_F(Interrupts, EndTheBakeOfAWindow) {
  scene::Source source;
  source.path = "phantom:ball:32";
  base::Progress progress;
  const auto volume = volume::loadVolume(source, progress);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.gi.samples = 1000000;  // for ever
  const scene::Scene resolved = scene::resolve(scene, volume->facts);
  const glm::vec3 centre = glm::vec3(volume->grid().dims() - 1) * 0.5f;
  gi::VisiblePointSet seen;
  for (int i = 0; i < 500; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / 500.0, angle = 2.4 * i, r = std::sqrt(1.0 - z * z);
    seen.outer.push_back(centre + 10.0f * glm::vec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  std::vector<double> times;
  const BusyProcesses busy;
  for (int i = 0; i < moments(); ++i) {
    auto controller =
        std::make_unique<app::LightController>(app::LightController::Options{.background = true});
    controller->setScene(resolved, volume);
    controller->setVisible(seen);
    ASSERT_TRUE(test::pollUntil([&] { return controller->state().counters.rays > 0; }));
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(
        std::uniform_real_distribution<double>(0.0, 40.0)(random_)));
    const auto begin = Clock::now();
    controller.reset();
    EXPECT_TRUE(base::awaitDestroyed(600.0));
    times.push_back(millisecondsSince(begin));
  }
  print("window", times);
}

TEST_F(Interrupts, EndPhantom) {
  interrupt({"phantom", "head", "--size", "256", "--out", "p.vti"});
}

TEST_F(Interrupts, EndOpening) {
  writePhantom();
  interrupt({"info", "v.vti"});
}

TEST_F(Interrupts, OfAClosedTerminalAndOfAnAdministratorToo) {
  for (const int number : {SIGHUP, SIGTERM}) interrupt({"bake", "phantom:ball:96", "--out", "b.vti"}, number);
}

}  // namespace
}  // namespace isolux::test
