// isolux bake under mpirun: any number of ranks makes the bake of one, byte for byte; ranks that end, stand
// still or would make other light are named.
#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

using Words = std::vector<std::string>;

Words joined(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Both lattices, sky and lamps; two tiles along each axis.
Words bakeWords(const std::string& out, const Words& more = {},
                const std::string& volume = "phantom:gyroid:48",
                const std::string& samples = "gi.samples=16") {
  return joined({"bake", volume, "--out", out, "--set", samples, "--set", "light.environment.builtin=studio",
                 "--set", "lamp1.shown=true"},
                more);
}

class BakeOverMpi : public testing::Test {
 protected:
  // Open MPI refuses root and more ranks than cores unless told otherwise.
  RunSettings settings() const {
    RunSettings settings;
    settings.program = "/usr/bin/mpirun";
    settings.folder = folder_;
    settings.environment = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                            "ISOLUX_TEST_MARK=" + mark_};
    return settings;
  }
  static Words launched(int ranks, const Words& isolux) {
    return joined({"--oversubscribe", "--bind-to", "none", "-n", std::to_string(ranks), ISOLUX_BINARY},
                  isolux);
  }
  RunResult overMpi(int ranks, const Words& isolux) const {
    return RunningIsolux(launched(ranks, isolux), settings()).wait();
  }
  // One rank with these words and one with those. Not as `mpirun ... : ...`, on which Open MPI 5.0.7 (Debian
  // 13) crashes.
  RunResult overMpi(const Words& first, const Words& second) const {
    const char* const chosen =
        R"(if [ "$OMPI_COMM_WORLD_RANK" = 0 ]; then exec "$0" "${@:2:$1}"; else exec "$0" "${@:$1+2}"; fi)";
    const Words chooser{"/bin/bash", "-c", chosen, ISOLUX_BINARY, std::to_string(first.size())};
    const Words words = joined({"--oversubscribe", "--bind-to", "none", "-n", "2"}, chooser);
    return RunningIsolux(joined(joined(words, first), second), settings()).wait();
  }
  RunResult alone(const Words& isolux) const { return callIsolux(isolux, folder_); }
  std::string bytesOf(const std::string& name) const { return contentOf(folder_ / name); }

  // The process that computes for a rank of this test's job, while there is one.
  std::optional<pid_t> processOf(int rank) const {
    const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank),
                      mark = "ISOLUX_TEST_MARK=" + mark_;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const std::string name = entry.path().filename().string();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      if (contentOf(entry.path() / "comm") != "isolux-program\n") continue;
      const std::string environment = '\0' + contentOf(entry.path() / "environ");
      if (environment.find('\0' + mark + '\0') != std::string::npos &&
          environment.find('\0' + wanted + '\0') != std::string::npos)
        return static_cast<pid_t>(std::stol(name));
    }
    return std::nullopt;
  }
  // Begins a bake, and sends the signal to that rank as soon as there is a checkpoint.
  RunResult signalled(const std::string& out, int rank, int signal, const Words& words) const {
    RunningIsolux job(launched(3, words), settings());
    EXPECT_TRUE(pollUntil([&] { return fs::exists(folder_ / out); }));
    const auto process = processOf(rank);
    EXPECT_TRUE(process) << "the bake was over before it was disturbed";
    if (process) ::kill(*process, signal);
    return job.wait();
  }

  fs::path folder_ = temporaryFolder();
  std::string mark_ = folder_.filename().string() + "-" + std::to_string(::getpid());
};

void expectSameArrays(const fs::path& whole, const fs::path& index) {
  vtkNew<vtkXMLImageDataReader> one;
  one->SetFileName(whole.c_str());
  one->Update();
  vtkNew<vtkXMLPImageDataReader> pieces;
  pieces->SetFileName(index.c_str());
  pieces->Update();
  vtkImageData *a = one->GetOutput(), *b = pieces->GetOutput();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(a->GetDimensions()[axis], b->GetDimensions()[axis]);
    EXPECT_EQ(a->GetOrigin()[axis], b->GetOrigin()[axis]);
    EXPECT_EQ(a->GetSpacing()[axis], b->GetSpacing()[axis]);
  }
  ASSERT_EQ(a->GetPointData()->GetNumberOfArrays(), b->GetPointData()->GetNumberOfArrays());
  ASSERT_GE(a->GetPointData()->GetNumberOfArrays(), 3);
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* const array = a->GetPointData()->GetArray(i);
    vtkDataArray* const other = b->GetPointData()->GetArray(array->GetName());
    ASSERT_TRUE(other) << array->GetName();
    ASSERT_EQ(array->GetDataSize(), other->GetDataSize());
    EXPECT_EQ(std::memcmp(array->GetVoidPointer(0), other->GetVoidPointer(0),
                          static_cast<std::size_t>(array->GetDataSize() * array->GetDataTypeSize())),
              0)
        << array->GetName();
  }
}

TEST_F(BakeOverMpi, AnyNumberOfRanksMakesTheBakeOfOne) {
  ASSERT_EQ(alone(bakeWords("whole.vti", {"--pieces", "3"})).exitCode, 0);
  expectSameArrays(folder_ / "whole.vti", folder_ / "whole.pvti");
  // A script of one rank: the second bake needs MPI as little as the first.
  const std::string script = "\"$0\" \"$@\" --out one.vti && \"$0\" \"$@\" --out again.vti";
  const Words bake{"bake", "phantom:gyroid:16", "--set", "gi.samples=4"};
  const Words both{"--oversubscribe", "--bind-to", "none", "-n",         "1",
                   "/bin/bash",       "-c",        script, ISOLUX_BINARY};
  const RunResult twice = RunningIsolux(joined(both, bake), settings()).wait();
  ASSERT_EQ(twice.exitCode, 0) << twice.err;
  EXPECT_TRUE(bytesOf("one.vti") == bytesOf("again.vti"));
  for (const int ranks : {2, 3, 5}) {
    const std::string name = "ranks" + std::to_string(ranks);
    const RunResult result =
        overMpi(ranks, bakeWords(name + ".vti", {"--pieces", "2", "--stats", name + ".json"}));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(bytesOf(name + ".vti") == bytesOf("whole.vti")) << ranks;
    expectSameArrays(folder_ / "whole.vti", folder_ / (name + ".pvti"));
    const auto stats = nlohmann::json::parse(bytesOf(name + ".json"));
    ASSERT_EQ(stats["bake"]["ranks"].size(), static_cast<std::size_t>(ranks));
    std::uint64_t tiles = 0;
    for (const auto& rank : stats["bake"]["ranks"]) {
      tiles += rank["tiles"].get<std::uint64_t>();
      EXPECT_FALSE(rank["host"].get<std::string>().empty());
      EXPECT_GE(rank["idle_share"].get<double>(), 0.0);
      EXPECT_TRUE(rank["answers"].get<bool>());
    }
    EXPECT_GE(tiles, 8u);
  }
  Words merge{"merge", "--out", "merged.vti"};
  for (const char* part : {"1", "2", "3"}) {
    ASSERT_EQ(alone(bakeWords("p.vti", {"--part", std::string(part) + "/3"})).exitCode, 0);
    merge.push_back("p.part-" + std::string(part) + "-of-3.vti");
  }
  ASSERT_EQ(alone(merge).exitCode, 0);
  EXPECT_TRUE(bytesOf("merged.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeOverMpi, ARankThatIsKilledEndsTheJobAndTheSameCommandGoesOn) {
  const auto words = [](const std::string& out) {
    return bakeWords(out, {"--checkpoint", "0.1", "--threads", "1"}, "phantom:gyroid:48", "gi.samples=16");
  };
  ASSERT_EQ(alone(words("whole.vti")).exitCode, 0);
  for (const int killed : {1, 0}) {
    const std::string out = "killed" + std::to_string(killed) + ".vti";
    const RunResult result = signalled(out, killed, SIGKILL, words(out));
    EXPECT_NE(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr("rank " + std::to_string(killed)));
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    EXPECT_THAT(result.err, HasSubstr(std::string("on node ") + host.data()));
    // The others have about a second after a worker's end, in which they may come to the end.
    if (killed == 0) {
      EXPECT_FALSE(bytesOf(out) == bytesOf("whole.vti"));
    }
    const RunResult again = overMpi(2, words(out));  // refuses a file that is not whole
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.err, testing::Not(HasSubstr("replaced")));
    EXPECT_TRUE(bytesOf(out) == bytesOf("whole.vti")) << killed;
  }
}

TEST_F(BakeOverMpi, ARankThatStandsStillIsNamedAndTheRestFinishes) {
  const auto words = [](const std::string& out) {
    return bakeWords(out, {"--checkpoint", "0.1", "--threads", "1"}, "phantom:gyroid:48", "gi.samples=16");
  };
  ASSERT_EQ(alone(words("whole.vti")).exitCode, 0);
  const RunResult result = signalled("light.vti", 1, SIGSTOP, words("light.vti"));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("rank 1 on "));
  EXPECT_THAT(result.err, HasSubstr("does not answer"));
  EXPECT_TRUE(bytesOf("light.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeOverMpi, RanksOfOtherArithmeticAreRefusedUnlessAllAreLowered) {
  const bool fused = (hwy::SupportedTargets() & (HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL | HWY_NEON)) != 0;
  const Words lowered{"--arithmetic", "no-fma"};
  const std::string volume = "phantom:gyroid:40", few = "gi.samples=4";
  const RunResult mixed =
      overMpi(bakeWords("mixed.vti", {}, volume, few), bakeWords("mixed.vti", lowered, volume, few));
  EXPECT_EQ(mixed.exitCode, fused ? 3 : 0) << mixed.err;
  if (fused) {
    EXPECT_THAT(mixed.err, HasSubstr("rank 1 on "));
    EXPECT_THAT(mixed.err, HasSubstr("use --arithmetic no-fma on all"));
    EXPECT_FALSE(fs::exists(folder_ / "mixed.vti"));
  }
  ASSERT_EQ(alone(bakeWords("whole.vti", lowered, volume, few)).exitCode, 0);
  const RunResult low = overMpi(2, bakeWords("low.vti", lowered, volume, few));
  ASSERT_EQ(low.exitCode, 0) << low.err;
  EXPECT_TRUE(bytesOf("low.vti") == bytesOf("whole.vti"));
  EXPECT_THAT(bytesOf("low.vti"), HasSubstr("\"arithmetic\""));
}

TEST_F(BakeOverMpi, ARankWithAnotherVolumeIsNamedAndASentOneIsTheSame) {
  const std::string few = "gi.samples=4";
  const Words right = bakeWords("light.vti", {}, "phantom:gyroid:40", few);
  const RunResult other = overMpi(right, bakeWords("light.vti", {}, "phantom:gyroid:41", few));
  EXPECT_EQ(other.exitCode, 3) << other.err;
  EXPECT_THAT(other.err, HasSubstr("isolux: rank 1 on "));
  EXPECT_THAT(other.err, HasSubstr("another volume"));
  EXPECT_FALSE(fs::exists(folder_ / "light.vti"));
  const Words sent = joined(right, {"--send-volume"});
  const RunResult result =
      overMpi(sent, joined({"bake", "nowhere.vti"}, Words(sent.begin() + 2, sent.end())));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  ASSERT_EQ(alone(bakeWords("whole.vti", {}, "phantom:gyroid:40", few)).exitCode, 0);
  EXPECT_TRUE(bytesOf("light.vti") == bytesOf("whole.vti"));
  const RunResult missing =
      overMpi(right, joined({"bake", "nowhere.vti"}, Words(right.begin() + 2, right.end())));
  EXPECT_EQ(missing.exitCode, 3);
  EXPECT_THAT(missing.err, HasSubstr("isolux: rank 1 on "));
  EXPECT_THAT(missing.err, HasSubstr("nowhere.vti"));
}

TEST_F(BakeOverMpi, ASecondBakeOfTheSameRanksIsRefusedInOneLine) {
  const std::string script = "\"$0\" \"$@\" --out one.vti && \"$0\" \"$@\" --out again.vti";
  const RunResult twice =
      RunningIsolux({"--oversubscribe", "--bind-to", "none", "-n", "2", "/bin/bash", "-c", script,
                     ISOLUX_BINARY, "bake", "phantom:gyroid:16", "--set", "gi.samples=4"},
                    settings())
          .wait();
  EXPECT_EQ(twice.exitCode, 3) << twice.err;
  EXPECT_THAT(twice.err, HasSubstr("isolux-mpi.so: MPI has been started in this rank before"));
  EXPECT_THAT(twice.err, HasSubstr("--no-mpi"));
  EXPECT_THAT(twice.err, Not(HasSubstr("internal error")));
  EXPECT_TRUE(fs::exists(folder_ / "one.vti"));
  EXPECT_FALSE(fs::exists(folder_ / "again.vti"));
}

TEST_F(BakeOverMpi, WrongUseOnRank0LetsAllGo) {
  const RunResult part = overMpi(2, bakeWords("light.vti", {"--part", "1/2"}));
  EXPECT_EQ(part.exitCode, 2);
  EXPECT_THAT(part.err, HasSubstr("--part"));
  const RunResult one =  // of two the second would be refused: it would write the same file
      overMpi(1, bakeWords("light.vti", {"--part", "1/2", "--no-mpi"}, "phantom:gyroid:16"));
  EXPECT_EQ(one.exitCode, 0) << "--no-mpi leaves each to itself: " << one.err;
}

TEST_F(BakeOverMpi, ARankThatIsBoundToOneCoreIsTold) {
  if (::sysconf(_SC_NPROCESSORS_ONLN) < 2) return;  // there is nothing to lose
  Words words{"--oversubscribe", "--bind-to", "core", "-n", "1", ISOLUX_BINARY};
  const RunResult bound =
      RunningIsolux(joined(words, bakeWords("light.vti", {}, "phantom:gyroid:16", "gi.samples=4")),
                    settings())
          .wait();
  ASSERT_EQ(bound.exitCode, 0) << bound.err;
  EXPECT_THAT(bound.err, HasSubstr("mpirun --bind-to none gives it all"));
}

}  // namespace
}  // namespace isolux::test
