// What others parse runs in a process of its own: whatever that does, reading ends with a volume or one line.
#include <cerrno>
#include <chrono>
#include <optional>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/paths.h"
#include "tests/volume/read/reader_support.h"
#include "volume/read/process/foreign.h"
#include "volume/read/process/reader_process.h"

namespace isolux {
namespace {

using base::ErrorKind;
using testing::HasSubstr;

struct Outcome {
  std::optional<base::Error> error;
  volume::Volume volume;
};

std::filesystem::path fakeReader() {
  return ISOLUX_FAKE_READER;
}

template <typename Read>
Outcome outcomeOf(Read&& read) {
  Outcome outcome;
  try {
    read(outcome);
  } catch (const base::Error& error) {
    outcome.error = error;
  }
  return outcome;
}

Outcome readByFake(const std::string& behaviour, double patienceSeconds = 30.0,
                   std::size_t budget = 1 << 20) {
  return outcomeOf([&](Outcome& outcome) {
    base::Progress progress;
    volume::ReadOptions options;
    options.budgetBytes = budget;
    outcome.volume = volume::readVolumeBy(fakeReader(), behaviour, options, progress, patienceSeconds);
  });
}

void expectRefusal(const Outcome& outcome, const std::string& reason, ErrorKind kind = ErrorKind::input) {
  ASSERT_TRUE(outcome.error);
  EXPECT_EQ(outcome.error->kind(), kind);
  EXPECT_THAT(outcome.error->place() + " " + outcome.error->reason(), HasSubstr(reason));
}

// No reader is left, not even a dead one.
void expectNoChildren() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ReaderProcess, HandsOverWhatItHasRead) {
  const Outcome outcome = readByFake("good");
  ASSERT_FALSE(outcome.error) << outcome.error->what();
  EXPECT_EQ(outcome.volume.format, "fake");
  EXPECT_EQ(outcome.volume.grid->dims(), glm::ivec3(2));
  for (int i = 0; i < 8; ++i) EXPECT_EQ(outcome.volume.grid->stored(i & 1, i >> 1 & 1, i >> 2), i);
  expectNoChildren();
}

TEST(ReaderProcess, ItsDeathIsOneLineThatNamesTheFileAndTheCause) {
  expectRefusal(readByFake("crash"), "the file is damaged: its reader ended by a segmentation fault");
  expectRefusal(readByFake("abort"), "its reader ended by an abort");
  expectRefusal(readByFake("exit"), "its reader ended with code 1");
  expectRefusal(readByFake("killed"), "lack of memory", ErrorKind::memory);
  expectRefusal(readByFake("crash after the announcement"), "segmentation fault");
  expectRefusal(readByFake("closes and stays"), "its reader closed the connection");
  EXPECT_EQ(readByFake("crash").error->file(), "crash");
  EXPECT_EQ(readByFake("crash in another file").error->file(), "/data/other.dcm");
  expectNoChildren();
}

TEST(ReaderProcess, ItsErrorsArePassedOn) {
  const Outcome outcome = readByFake("error");
  ASSERT_TRUE(outcome.error);
  EXPECT_STREQ(outcome.error->what(), base::Error(ErrorKind::usage, "f", "p", "r").what());
  EXPECT_EQ(outcome.error->kind(), ErrorKind::usage);
}

TEST(ReaderProcess, AnswersThatMakeNoSenseAreRefused) {
  expectRefusal(readByFake("another version"), "not of this version");
  expectRefusal(readByFake("unknown message"), "out of range");
  expectRefusal(readByFake("mesh instead"), "does not answer the request");
  expectRefusal(readByFake("endless message"), "out of range");
  expectRefusal(readByFake("truncated body"), "ends too early");
  expectRefusal(readByFake("body too long"), "beyond its end");
  expectRefusal(readByFake("long text"), "ends too early");
  expectRefusal(readByFake("no voxels"), "out of range");
  expectRefusal(readByFake("negative size"), "out of range");
  expectRefusal(readByFake("too large"), "budget", ErrorKind::memory);
  expectRefusal(readByFake("nan matrix"), "not finite");
  expectRefusal(readByFake("flat matrix"), "degenerate");
  expectRefusal(readByFake("nan progress"), "not finite");
  expectRefusal(readByFake("shrinks the memory"), "another size");
  expectRefusal(readByFake("error of another kind"), "out of range");
  expectNoChildren();
}

TEST(ReaderProcess, MeshesAndImagesAreCheckedToo) {
  base::Progress progress;
  expectRefusal(outcomeOf([&](Outcome&) {
                  volume::readPolyDataMesh("wrong triangle", 1 << 20, progress, fakeReader());
                }),
                "is not a point of the mesh");
  expectRefusal(outcomeOf([&](Outcome&) { volume::readImage("endless image", progress, fakeReader()); }),
                "larger than one may be");
}

TEST(ReaderProcess, TheSharedMemoryStaysWithinTheBudget) {
  expectRefusal(readByFake("good", 30.0, 7), "budget", ErrorKind::memory);
}

TEST(ReaderProcess, WhoSpinsIsEndedByItsLimitOfProcessorTime) {
  expectRefusal(readByFake("spin"), "of processor time");
}

TEST(ReaderProcess, WhoNeitherWorksNorAnswersIsEnded) {
  expectRefusal(readByFake("sleep", 0.3), "neither works nor answers");
  expectNoChildren();
}

TEST(ReaderProcess, ItsLimitsHold) {
  const Outcome outcome = readByFake("limits");
  EXPECT_FALSE(outcome.error) << outcome.error->what();
}

// A reader that never answers and never ends of itself is ended by the stop, whenever that comes.
TEST(ReaderProcess, AStopEndsItAtOnce) {
  for (int i = 0; i < 5; ++i) {
    base::Progress progress;
    std::jthread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(15 * i));  // any moment will do
      progress.requestStop();
    });
    const Outcome outcome = outcomeOf([&](Outcome&) {
      volume::readVolumeBy(fakeReader(), "spin without limits", volume::ReadOptions(), progress);
    });
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->kind(), ErrorKind::interrupted);
    expectNoChildren();
  }
}

TEST(ReaderProcess, AMissingReaderIsSaid) {
  expectRefusal(outcomeOf([](Outcome&) { volume::readerProgram("isolux-reader-nothing"); }), "is missing");
  expectRefusal(outcomeOf([](Outcome&) {
                  base::Progress progress;
                  volume::readVolumeBy("/no/such/reader", "f", volume::ReadOptions(), progress);
                }),
                "cannot be started");
}

TEST(ReaderProcess, ReadersTellTheirVersions) {
  base::Progress progress;
  EXPECT_THAT(volume::readerVersions(progress),
              testing::ElementsAre(testing::StartsWith("VTK 9"), testing::StartsWith("vtk-dicom "),
                                   testing::StartsWith("OpenImageIO 2"), testing::HasSubstr("flying edges"),
                                   testing::StartsWith("HDF5 1.")));
}

}  // namespace
}  // namespace isolux
