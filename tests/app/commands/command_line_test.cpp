// The command line: exit codes, messages, output, interrupts. Nothing here needs GL.
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "app/launcher/command_names.h"
#include "base/destroy_in_background.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/settings.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/paths.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::callIsolux;
using test::runIsolux;
using test::RunResult;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// Runs in a folder of its own, expects one line on stderr and this exit code, and nothing left behind.
std::string failure(int exitCode, const std::vector<std::string>& arguments) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = callIsolux(arguments, folder);
  const std::string shown = testing::PrintToString(arguments);
  EXPECT_EQ(result.exitCode, exitCode) << shown << '\n' << result.err;
  EXPECT_TRUE(result.isOneErrorLine()) << shown << '\n' << result.err;
  EXPECT_EQ(result.out, "") << shown;
  EXPECT_THAT(test::filesIn(folder), IsEmpty()) << shown;
  return result.err;
}

RunResult success(const std::vector<std::string>& arguments,
                  const fs::path& folder = test::temporaryFolder()) {
  const RunResult result = callIsolux(arguments, folder);
  EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(arguments) << '\n' << result.err;
  return result;
}

TEST(CommandLine, TheProgramItselfReportsAndExits) {
  const fs::path folder = test::temporaryFolder();
  const auto expect = [&](int exitCode, const std::vector<std::string>& arguments) {
    const RunResult result = runIsolux(arguments, {.folder = folder});
    EXPECT_EQ(result.exitCode, exitCode) << testing::PrintToString(arguments);
    EXPECT_EQ(result.isOneErrorLine(), exitCode != 0) << result.err;
    EXPECT_EQ(result.out.empty(), exitCode != 0) << result.out;
  };
  expect(0, {"--version"});
  expect(0, {"info", "phantom:ball:8"});
  expect(2, {"inof"});
  expect(2, {"render", "phantom:ball:8", "--out", "a.jpg"});
  expect(3, {"info", "missing.nii"});
  expect(3, {"missing.isolux"});
  std::ofstream(folder / "broken.png") << "\x89PNG\r\n\x1a\nand then nonsense";
  expect(3, {"info", "broken.png"});
  EXPECT_THAT(test::filesIn(folder), ElementsAre("broken.png"));
}

std::vector<std::string> commandNames() {
  const std::string help = success({"--help"}).out;
  std::istringstream lines(help.substr(help.find("Subcommands:\n") + 13));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");)
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

// The launcher watches over these words alone, whatever files there are.
TEST(CommandLine, TheLauncherKnowsTheNamesOfAllCommands) {
  EXPECT_THAT(commandNames(), testing::UnorderedElementsAreArray(kCommandNames));
}

TEST(CommandLine, ACommandIsSupervisedWhateverStandsInTheFolder) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directory(folder / "bake");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"bake", "phantom:torus:64", "--out", "l.vti", "--set", "gi.samples=4096"},
           {"--threads", "1", "bake", "phantom:torus:64", "--out", "l.vti", "--set", "gi.samples=4096"}}) {
    test::RunningIsolux isolux(arguments, {.folder = folder});
    EXPECT_TRUE(test::pollUntil([&] { return isolux.processorSeconds() > 0.0; }))
        << "the child of a supervisor";
    isolux.signal(SIGINT);
    EXPECT_EQ(isolux.wait().exitCode, 130);
  }
}

// What some job starters do. The next files that are opened take these numbers.
TEST(CommandLine, ClosedStandardDescriptorsChangeNothing) {
  const fs::path folder = test::temporaryFolder();
  const std::string call = "cd '" + folder.string() + "' && '" ISOLUX_BINARY "' ";
  for (const char* closed : {"<&- >&- 2>&-", "<&-", ">&-", "2>&-", "<&- >&-"}) {
    EXPECT_EQ(std::system((call + "info phantom:ball:8 " + closed).c_str()), 0) << closed;
    EXPECT_EQ(std::system((call + "mesh phantom:ball:16 --out a.stl " + closed).c_str()), 0) << closed;
    EXPECT_GT(fs::file_size(folder / "a.stl"), 84u);
    fs::remove(folder / "a.stl");
  }
}

TEST(CommandLine, WrongUseIsExit2) {
  EXPECT_THAT(failure(2, {"inof"}), HasSubstr("did you mean info?"));
  EXPECT_THAT(failure(2, {"inof", "phantom:head"}), HasSubstr("did you mean info?"));
  EXPECT_THAT(failure(2, {"rendr", "a.nii", "--out", "a.png"}), HasSubstr("did you mean render?"));
  EXPECT_THAT(failure(2, {"xyzzy"}), HasSubstr("isolux --help"));
  EXPECT_THAT(failure(2, {"info"}), HasSubstr("PATH"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--jsn"}), HasSubstr("did you mean --json?"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8"}), HasSubstr("--out"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.jpg"}), HasSubstr(".png or .exr"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a"}), HasSubstr(".png or .exr"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.png", "--aov", "normal"}),
              HasSubstr(".exr"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.exr", "--aov", "normals"}),
              HasSubstr("normals"));
  for (const char* size : {"10", "10x", "x10", "0x5", "5x0", "-5x5", "10x10x10", "99999x1", "ax b", ""})
    EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.png", "--size", size}),
                HasSubstr("--size"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.png", "--context", "vulkan"}),
              HasSubstr("--context"));
  EXPECT_THAT(failure(2, {"render", "phantom:head:8", "--out", "a.png", "--repeat", "-1"}),
              HasSubstr("--repeat"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--threads", "0"}), HasSubstr("--threads"));
  EXPECT_THAT(failure(2, {"info", "phantom:heda:8"}), HasSubstr("heda"));
  EXPECT_THAT(failure(2, {"replay", "r.jsonl", "--out", "d", "--fps", "0"}), HasSubstr("--fps"));
}

TEST(CommandLine, SettingsAreCheckedBeforeAnythingRuns) {
  const auto set = [](const char* assignment) {
    return failure(2, {"render", "missing.nii", "--out", "a.png", "--set", assignment});
  };
  EXPECT_THAT(set("camera.fov=500"), AllOf(HasSubstr("camera.fov"), HasSubstr("500"), HasSubstr("1 to 160")));
  EXPECT_THAT(set("camera.fow=50"), HasSubstr("did you mean camera.fov?"));
  EXPECT_THAT(set("camera.fov"), HasSubstr("PATH=VALUE"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--isovalue", "bone"}), HasSubstr("isosurface.value"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--look", "shiny"}), HasSubstr("look.mode"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--camera", "1,2,3"}), HasSubstr("--camera"));
  EXPECT_THAT(failure(2, {"info", "phantom:head:8", "--camera", "1,2,3 0,0,0 0,0,0 30"}),
              HasSubstr("camera.up"));
  EXPECT_THAT(failure(2, {"missing.nii", "--set", "camera.fov=500"}), HasSubstr("camera.fov"))
      << "the window too";
}

TEST(CommandLine, UnreadableInputIsExit3) {
  EXPECT_THAT(failure(3, {"info", "missing.nii"}), HasSubstr("missing.nii"));
  EXPECT_THAT(failure(3, {"render", "missing.nii", "--out", "a.png"}), HasSubstr("missing.nii"));
  EXPECT_THAT(failure(3, {"info", "phantom:head:8", "--session", "missing.isolux"}),
              HasSubstr("missing.isolux"));
  EXPECT_THAT(failure(3, {"replay", "missing.jsonl", "--out", "frames"}), HasSubstr("missing.jsonl"));
  EXPECT_THAT(failure(3, {"render", "phantom:head:8", "--out", "no/a.png"}), HasSubstr("no/a.png"));
  EXPECT_THAT(failure(3, {"render", "phantom:head:8", "--out", "a.png", "--stats", "no/a.json"}),
              HasSubstr("no/a.json"));
  EXPECT_THAT(failure(3, {"phantom", "ball", "--size", "8", "--out", "no/a.mha"}), HasSubstr("no/a.mha"));
}

TEST(CommandLine, BadSessionsNameTheKey) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "s.isolux") << R"({"isolux_session": 2, "scene": {"camera": {"fow": 3}}})";
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"info", "s.isolux"}, {"info", "phantom:ball:8", "--session", "s.isolux"}, {"s.isolux"}}) {
    const RunResult result = callIsolux(arguments, folder);
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("s.isolux"), HasSubstr("scene.camera.fow")));
  }
}

TEST(CommandLine, ASessionAloneSaysWhatToOpen) {
  const fs::path folder = test::temporaryFolder();
  scene::Scene scene;
  scene.source.path = "phantom:torus:12";
  saveSession(scene, folder / "s.isolux");
  EXPECT_EQ(json::parse(success({"info", "--session", "s.isolux", "--json"}, folder).out)["dims"][0], 12);
  success({"reference", "--session", "s.isolux", "--spp", "1", "--size", "8x6", "--out", "a.png"}, folder);
  success({"bake", "--session", "s.isolux", "--set", "gi.samples=1", "--out", "a.vti"}, folder);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"info"},
                                             {"render", "--out", "a.png"},
                                             {"bake", "--out", "a.vti"},
                                             {"reference", "--out", "a.exr"},
                                             {"study", "--out", "d"}})
    EXPECT_THAT(failure(2, words), HasSubstr("PATH"));
}

TEST(CommandLine, APictureWithASessionIsMadeAgainInItsSize) {
  const fs::path folder = test::temporaryFolder();
  const auto reference = [&](const std::string& path, const char* out, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"reference", path, "--spp", "1", "--out", out});
    success(more, folder);
    return pngSize(folder / out);
  };
  EXPECT_EQ(reference("phantom:ball:8", "a.png", {"--size", "21x17"}), glm::ivec2(21, 17));
  EXPECT_EQ(reference("a.png", "b.png"), glm::ivec2(21, 17));
  EXPECT_EQ(reference("a.png", "c.png", {"--size", "9x8"}), glm::ivec2(9, 8));
  success({"reference", "a.png", "--spp", "1", "--size", "9x8", "--out", "a.exr"}, folder);
  EXPECT_EQ(json::parse(success({"info", "a.exr", "--json"}, folder).out)["dims"][0], 8)
      << "its session, too";
}

TEST(CommandLine, WhatFilesSayReachesTheTerminalWithoutControlCharacters) {
  const fs::path folder = test::temporaryFolder();
  const std::string name =
      "a\x1b]0;title\x07\xc2\x9b"
      "31m.nrrd";
  std::ofstream(folder / name) << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n"
                                  "space: \x1b[31mred\n\n01234567 and more";
  std::ofstream(folder / "b.nrrd") << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n"
                                      "01234567";
  const auto clean = [](const std::string& text) {
    return text.find_first_of("\x1b\x07\x7f") == std::string::npos &&
           text.find("\xc2\x9b") == std::string::npos;
  };
  const RunResult read = callIsolux({"info", name}, folder);
  EXPECT_TRUE(clean(read.out)) << read.out;
  EXPECT_TRUE(clean(read.err)) << read.err;
  fs::rename(folder / "b.nrrd", folder / ("b" + name));
  const RunResult named = success({"info", "b" + name}, folder);
  EXPECT_THAT(named.out, HasSubstr("ba?]0;title??31m.nrrd"));
  EXPECT_TRUE(clean(named.out));
}

TEST(CommandLine, ADeletedWorkingFolderIsAPlainLine) {
  const fs::path folder = test::temporaryFolder() / "gone";
  fs::create_directory(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  fs::remove(folder);
  testing::internal::CaptureStderr();
  std::vector<std::string> words{"isolux", "info", "v.vti"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  const int exitCode = runCommandLine(3, argv.data(), [](const WindowRequest&) { return 0; });
  const std::string text = testing::internal::GetCapturedStderr();
  fs::current_path(before);
  EXPECT_EQ(exitCode, 3);
  EXPECT_EQ(text, "isolux: v.vti: No such file or directory\n");
}

TEST(CommandLine, MessagesAreOneLineWhateverTheInput) {
  failure(3, {"info", "a\nb\x1b[31m.nii"});
  failure(2, {"info", "phantom:head:8", "--set", "camera.fov=1\n2"});
  failure(2, {"info", "phantom:head:8", "--set", std::string(5000, 'x') + "=1"});
  failure(3, {"info", "caf\xe9.nii"});
}

TEST(CommandLine, TooLittleMemoryIsExit5) {
  if (sanitized) GTEST_SKIP() << "sanitizers reserve address space of their own";
  const RunResult result =
      runIsolux({"info", "phantom:head:1024"}, {.addressSpace = std::size_t{1500} << 20});
  EXPECT_EQ(result.exitCode, 5);
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
}

TEST(CommandLine, TheMemoryBudgetRefusesWithTheSumAndTheSetting) {
  const auto refused = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--memory-budget", "1M"});
    const std::string line = failure(5, arguments);
    EXPECT_THAT(line, AllOf(HasSubstr(" needed"), HasSubstr("memory budget of 1.0 MiB"),
                            HasSubstr("--memory-budget")));
    return line;
  };
  EXPECT_THAT(refused({"info", "phantom:ball:256"}), HasSubstr("64.0 MiB"));
  EXPECT_THAT(refused({"phantom", "ball", "--size", "128", "--out", "ball.mha"}),
              HasSubstr("a smaller size needs less"));
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "v.raw") << std::string(2000000, 'x');
  refused({"info", (folder / "v.raw").string(), "--raw", "200x100x100 uint8"});
  success({"info", (folder / "v.raw").string(), "--raw", "200x100x100 uint8", "--memory-budget", "64M"});
}

TEST(CommandLine, LightAndPathTracedPicturesAskTheBudgetBeforeTheyBegin) {
  const auto refused = [](const std::vector<std::string>& arguments, const char* budget) {
    EXPECT_TRUE(base::awaitDestroyed(30.0));  // what the command before this one held, in this process
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--memory-budget", budget});
    return failure(5, all);
  };
  const std::vector<std::string> bake{
      "bake",  "phantom:ball:64", "--set", "gi.mode=transfer", "--set", "gi.extent=full",
      "--set", "gi.sh_order=5",   "--out", "light.vti",        "--set", "light.environment.constant=1,2,3"};
  EXPECT_THAT(refused(bake, "30M"), AllOf(HasSubstr("64 x 64 x 64 texels"), HasSubstr("order 5"),
                                          HasSubstr("gi.lattice_scale"), HasSubstr("30.0 MiB")));
  EXPECT_THAT(refused(bake, "1500K"), HasSubstr("the tables of light tracing"));
  EXPECT_THAT(refused({"reference", "phantom:ball:16", "--size", "16384x16384", "--out", "r.exr"}, "200M"),
              AllOf(HasSubstr("a path traced image"), HasSubstr("a smaller one needs less")));
  EXPECT_THAT(refused({"info", "phantom:ball:64", "--set", "source.csg=union", "--set",
                       "source.csg_path=phantom:torus:64"},
                      "2600K"),
              HasSubstr("the combined volume"));
  EXPECT_THAT(refused({"info", "phantom:ball:64"}, "1100K"), HasSubstr("min-max blocks"));
}

// What a user of a small machine meets, as `ulimit -v`: a line and exit code 5, or success.
TEST(CommandLine, NoAddressSpaceIsTooSmallForALine) {
  if (sanitized) GTEST_SKIP() << "sanitizers reserve address space of their own";
  for (std::size_t mib = 560; mib <= 1200; mib += 160) {
    const fs::path folder = test::temporaryFolder();
    const RunResult result = runIsolux({"render", "phantom:ball:32", "--size", "64x48", "--look", "gi",
                                        "--set", "gi.samples=4", "--out", "a.png"},
                                       {.folder = folder, .addressSpace = mib << 20});
    if (result.exitCode == 127) continue;  // libraries themselves do not fit
    EXPECT_TRUE(result.exitCode == 0 || (result.exitCode == 5 && result.isOneErrorLine()))
        << mib << " MiB: " << result.exitCode << ' ' << result.err;
    EXPECT_EQ(test::filesIn(folder).size(), result.exitCode == 0 ? 1u : 0u);
  }
}

TEST(CommandLine, MoreThreadsThanMakeSenseAreNotMade) {
  const RunResult result = runIsolux({"info", "phantom:ball:32", "--threads", "1024"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("threads are used, the most that is useful on this computer"));
  EXPECT_THAT(failure(3, {"info", "missing.nii", "--threads", "1024"}), HasSubstr("missing.nii"));
}

TEST(CommandLine, TheMemoryBudgetIsASizeAndHoldsForOneCommand) {
  for (const char* wrong : {"none", "0", "-5G", "12Q"})
    EXPECT_THAT(failure(2, {"info", "phantom:ball:8", "--memory-budget", wrong}), HasSubstr("is not a size"));
  failure(5, {"info", "phantom:ball:64", "--memory-budget", "10K"});
  success({"info", "phantom:ball:64"});
  EXPECT_THAT(success({"doctor", "--memory-budget", "3 GiB"}).out, HasSubstr("memory budget 3.0 GiB"));
}

TEST(CommandLine, HelpCoversEveryCommandAndOption) {
  const std::string help = success({"--help"}).out;
  constexpr std::array commands{"info",  "render",  "bake",     "reference", "replay",
                                "study", "phantom", "settings", "doctor"};
  for (const char* name : commands) {
    EXPECT_THAT(help, HasSubstr(name));
    const RunResult result = success({name, "--help"});
    EXPECT_THAT(result.out, HasSubstr(std::string("  isolux ") + name)) << "an example";
    EXPECT_EQ(result.err, "");
  }
  const std::string page =
      test::contentOf(fs::path(ISOLUX_SOURCE_DIR) / "docs" / "reference" / "commands.md");
  for (const char* name : commands) {
    const std::string text = success({name, "--help"}).out;
    for (std::size_t at = 0; (at = text.find("  --", at)) != std::string::npos; ++at) {
      const std::string option = text.substr(at + 2, text.find_first_of(" ,\n", at + 2) - at - 2);
      EXPECT_THAT(page, HasSubstr(option)) << "docs/reference/commands.md does not mention it";
    }
  }
}

TEST(CommandLine, TheManualPageHasEveryCommandAndOption) {
  const std::string page = success({"--made-page", "man"}).out;
  EXPECT_THAT(page, testing::StartsWith(".TH ISOLUX 1 "));
  EXPECT_THAT(success({"--help"}).out, testing::Not(HasSubstr("made-page")));
  for (const char* name :
       {"info", "render", "bake", "reference", "replay", "study", "phantom", "settings", "doctor"}) {
    const std::size_t start = page.find(std::string(".SS \"isolux ") + name + "\"\n");
    ASSERT_NE(start, std::string::npos) << name;
    const std::string section = page.substr(start, page.find("\n.S", start + 1) - start);
    const std::string help = success({name, "--help"}).out;
    for (std::size_t at = 0; (at = help.find("\n  --", at)) != std::string::npos; ++at) {
      const std::string option = help.substr(at + 5, help.find_first_of(" ,\n", at + 5) - at - 5);
      std::string written = "\\-\\-";
      for (const char c : option) written += c == '-' ? "\\-" : std::string(1, c);
      EXPECT_THAT(section, HasSubstr(written)) << name;
    }
  }
  // Text that begins with a point would be taken for a request to roff.
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('.') || line.starts_with('\'')) {
      EXPECT_THAT(line, testing::MatchesRegex("\\.(TH|SH|SS|TP|PP|B|br|nf|fi|nh|ad)( .*)?"));
    }
}

TEST(CommandLine, VersionIsPrinted) {
  EXPECT_THAT(success({"--version"}).out, testing::MatchesRegex("isolux [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(InfoCommand, JsonHasTheDocumentedKeys) {
  const json info = json::parse(success({"info", "phantom:ball:16", "--json"}).out);
  std::vector<std::string> keys;
  for (const auto& [key, value] : info.items()) keys.push_back(key);
  EXPECT_THAT(keys, testing::UnorderedElementsAre(
                        "name", "format", "dims", "type", "stored_type", "spacing_mm", "origin_mm",
                        "directions", "orientation_stated", "unit", "kind", "kind_reason", "slope",
                        "intercept", "range", "missing", "labels", "label_table", "suggested_isovalue",
                        "contrast_isovalue", "noise", "derivatives_at_suggested", "histogram", "blocks",
                        "components", "time_steps", "series", "data_hash", "warnings"));
  EXPECT_EQ(info["dims"], json({16, 16, 16}));
  EXPECT_EQ(info["type"], "float32");
  EXPECT_EQ(info["directions"].size(), 3u);
  EXPECT_EQ(info["orientation_stated"], false);
  EXPECT_EQ(info["range"].size(), 2u);
  EXPECT_LT(info["range"][0], info["suggested_isovalue"]);
  EXPECT_EQ(info["data_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(info["missing"], 0);
  std::uint64_t counted = 0;
  for (const auto& count : info["histogram"]["counts"]) counted += count.get<std::uint64_t>();
  EXPECT_EQ(counted, 16u * 16 * 16);
  EXPECT_GT(info["blocks"]["active_at_suggested"], 0);
  EXPECT_LE(info["blocks"]["active_at_suggested"], info["blocks"]["total"]);
}

TEST(InfoCommand, TextSaysTheSame) {
  const std::string text = success({"info", "phantom:ball:16"}).out;
  EXPECT_THAT(text, AllOf(HasSubstr("16 x 16 x 16"), HasSubstr("float32"), HasSubstr("spacing"),
                          HasSubstr("orientation   not stated")));
  EXPECT_THAT(text, testing::Not(HasSubstr("LPS")));
  EXPECT_THAT(success({"info", "phantom:head:16"}).out,
              AllOf(HasSubstr("mm (LPS)"), HasSubstr("orientation   x to L, y to P, z to S")));
}

TEST(InfoCommand, TakesSessionsAndSettingsInOrder) {
  const fs::path folder = test::temporaryFolder();
  scene::Scene scene;
  scene.source.path = "phantom:torus:12";
  saveSession(scene, folder / "s.isolux");
  const auto dims = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"info", "--json"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return json::parse(success(all, folder).out)["dims"][0].get<int>();
  };
  EXPECT_EQ(dims({"s.isolux"}), 12);
  EXPECT_EQ(dims({"phantom:ball:10", "--session", "s.isolux"}), 10);
  EXPECT_EQ(dims({"s.isolux", "--set", "source.path=phantom:ball:9", "--set", "source.path=phantom:ball:8"}),
            8);
}

TEST(PhantomCommand, WritesVolumesThatReadBackTheSame) {
  const fs::path folder = test::temporaryFolder();
  const auto hash = [&](const std::string& path) {
    return json::parse(success({"info", path, "--json"}, folder).out);
  };
  const json made = hash("phantom:torus:20");
  for (const char* name : {"a.mha", "b.mhd", "c.nrrd", "d.vti"}) {
    success({"phantom", "torus", "--size", "20", "--out", name}, folder);
    const json read = hash(name);
    EXPECT_EQ(read["dims"], made["dims"]) << name;
    EXPECT_EQ(read["range"], made["range"]) << name;
    EXPECT_EQ(read["data_hash"], made["data_hash"]) << name;
  }
  EXPECT_THAT(test::filesIn(folder), ElementsAre("a.mha", "b.mhd", "b.raw", "c.nrrd", "d.vti"));
}

TEST(PhantomCommand, NoiseFollowsTheSeed) {
  const fs::path folder = test::temporaryFolder();
  const auto write = [&](const char* name, const char* seed) {
    success({"phantom", "ball", "--size", "12", "--noise", "2", "--seed", seed, "--out", name}, folder);
    return test::contentOf(folder / name);
  };
  const std::string first = write("a.mha", "1");
  EXPECT_EQ(write("b.mha", "1"), first);
  EXPECT_NE(write("c.mha", "2"), first);
}

TEST(PhantomCommand, ListsAndRefuses) {
  EXPECT_THAT(success({"phantom", "list"}).out, AllOf(HasSubstr("head"), HasSubstr("torus")));
  EXPECT_THAT(failure(2, {"phantom", "bal", "--out", "a.mha"}), HasSubstr("did you mean ball?"));
  EXPECT_THAT(failure(2, {"phantom", "ball"}), HasSubstr("--out"));
  EXPECT_THAT(failure(2, {"phantom", "ball", "--size", "1", "--out", "a.mha"}), HasSubstr("--size"));
  EXPECT_THAT(failure(2, {"phantom", "ball", "--noise", "-1", "--out", "a.mha"}), HasSubstr("--noise"));
  EXPECT_THAT(failure(2, {"phantom", "ball", "--size", "8", "--out", "a.xyz"}), HasSubstr("a.xyz"));
}

TEST(SettingsCommand, ListsEachSetting) {
  const std::string text = success({"settings"}).out, page = success({"settings", "--markdown"}).out;
  for (const scene::Setting& setting : scene::settings()) {
    EXPECT_THAT(text, HasSubstr(setting.path));
    const std::string group = setting.path.substr(0, setting.path.find('.'));
    const bool listed = !testing::Matches(testing::AnyOf("isosurface3", "isosurface4"))(group);
    EXPECT_EQ(page.find("- `" + setting.path + "` (") != std::string::npos, listed) << setting.path;
  }
}

TEST(SettingsCommand, ListsAsJsonAndByWord) {
  const json all = json::parse(success({"settings", "--json"}).out);
  std::size_t ofItems = 0;
  for (const scene::SceneList& list : scene::sceneLists()) ofItems += list.fields.size();
  ASSERT_EQ(all.size(), scene::settings().size() + ofItems + scene::hostSettings().size());
  std::size_t at = 0;
  const auto expectNext = [&](const auto& setting, const char* of) {
    const json& listed = all[at++];
    EXPECT_EQ(listed["path"], setting.path);
    EXPECT_EQ(listed["default"], setting.defaultValue());
    EXPECT_EQ(listed["unit"], setting.unit);
    EXPECT_EQ(listed["of"], of);
    EXPECT_EQ(listed.contains("choices"), setting.type == scene::SettingType::choice);
  };
  for (const scene::Setting& setting : scene::settings()) expectNext(setting, "scene");
  for (const scene::SceneList& list : scene::sceneLists())
    for (const scene::SettingInfo& field : list.fields) EXPECT_EQ(all[at++]["path"], field.path);
  for (const scene::HostSetting& setting : scene::hostSettings()) expectNext(setting, "machine");
  const json some = json::parse(success({"settings", "camera.fov", "--json"}).out);
  ASSERT_GE(some.size(), 1u);
  EXPECT_EQ(some[0]["path"], "camera.fov");
  EXPECT_THAT(success({"settings", "camera.fov"}).out, testing::Not(HasSubstr("isosurface.opacity")));
  failure(2, {"settings", "--json", "--markdown"});
}

TEST(DoctorCommand, SaysWhatIsThere) {
  const std::string text = success({"doctor"}).out;
  EXPECT_THAT(text,
              AllOf(HasSubstr("isolux"), HasSubstr("CPU threads"), HasSubstr("memory"), HasSubstr("ffmpeg"),
                    HasSubstr("OSMesa"), HasSubstr("shader cache  "), HasSubstr("isolux/programs"),
                    HasSubstr("MAX_3D_TEXTURE_SIZE: "), HasSubstr("memory.gpu_budget_mb")));
}

// Until it has used a second of the processor: the command line is behind it then, whatever else the machine
// does.
void waitUntilItWorks(const test::RunningIsolux& running) {
  ASSERT_TRUE(test::pollUntil([&] { return running.processorSeconds() >= 1.0; }));
}

TEST(Interrupt, StopsWithoutATrace) {
  for (const int number : {SIGINT, SIGTERM}) {
    const fs::path folder = test::temporaryFolder();
    test::RunningIsolux running({"phantom", "head", "--size", "1024", "--out", "a.mha"}, {.folder = folder});
    waitUntilItWorks(running);
    running.signal(number);
    const RunResult result = running.wait();
    EXPECT_EQ(result.exitCode, 130) << "the whole phantom takes minutes of the processor";
    EXPECT_EQ(result.err, "isolux: interrupted\n");
    EXPECT_THAT(test::filesIn(folder), IsEmpty());
  }
}

TEST(CommandLine, WithoutASubcommandTheWindowIsAskedFor) {
  const auto request = [](std::vector<std::string> words) {
    std::vector<char*> argv;
    words.insert(words.begin(), "isolux");
    for (std::string& word : words) argv.push_back(word.data());
    WindowRequest seen;
    const int code = runCommandLine(static_cast<int>(argv.size()), argv.data(), [&](const WindowRequest& r) {
      seen = r;
      return 42;
    });
    EXPECT_EQ(code, 42);
    return seen;
  };
  EXPECT_TRUE(request({}).scene == scene::Scene{});
  const WindowRequest full =
      request({"phantom:ball:8", "--isovalue", "-3", "--set", "look.mode=depth", "--isovalue", "5",
               "--camera", "1,2,3 0,0,0 0,0,1 40", "--record", "r.jsonl"});
  EXPECT_EQ(full.scene.source.path, "phantom:ball:8");
  EXPECT_EQ(full.scene.surfaces.front().value, 5.0);
  EXPECT_EQ(full.recordFile, "r.jsonl");
  EXPECT_EQ(full.scene.look.mode, scene::LookMode::depth);
  EXPECT_EQ(full.scene.camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(full.scene.camera.fov, 40.0);
  EXPECT_EQ(full.sessionFile, "");

  // A session is loaded and remembered; a volume beside it is a new document.
  const std::filesystem::path file = test::temporaryFolder() / "a.isolux";
  scene::Scene saved;
  saved.source.path = "phantom:torus:8";
  saved.look.ambient = 0.5;
  saveSession(saved, file);
  for (const auto& words : {std::vector<std::string>{file.string()}, {"--session", file.string()}}) {
    const WindowRequest opened = request(words);
    EXPECT_TRUE(opened.scene == saved);
    EXPECT_EQ(opened.sessionFile, file.string());
  }
  const WindowRequest other = request({"phantom:ball:8", "--session", file.string()});
  EXPECT_EQ(other.scene.source.path, "phantom:ball:8");
  EXPECT_EQ(other.scene.look.ambient, 0.5);
  EXPECT_EQ(other.sessionFile, "");
}

TEST(CommandLine, RecordRefusesWhatIsNoRecordingBeforeTheWindowOpens) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "scan.nii") << "precious voxels";
  const auto result = test::callIsolux({"phantom:ball:8", "--record", "scan.nii"}, folder);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_TRUE(result.isOneErrorLine());
  EXPECT_THAT(result.err, HasSubstr("scan.nii"));
  EXPECT_EQ(test::contentOf(folder / "scan.nii"), "precious voxels");
}

TEST(CommandLine, ARecordingIsKnownAndSaysHowItIsReplayed) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "r.jsonl") << "{\"isolux_recording\": 1, \"scene\": {}}\n";
  const auto result = test::callIsolux({"r.jsonl"}, folder);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("isolux replay r.jsonl --out"));
}

// The nth of the three volumes has values 10 n ... 10 n + 7.
TEST(CommandLine, TimeStepsAndChannelsAreChosenInAWord) {
  const fs::path folder = test::temporaryFolder();
  for (const std::string kind : {"list", "vector"}) {
    std::ofstream file(folder / (kind + ".nrrd"), std::ios::binary);
    file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 4\nsizes: 2 2 2 3\nkinds: domain domain domain "
         << kind << "\n\n";
    for (int volume = 0; volume < 3; ++volume)
      for (int i = 0; i < 8; ++i) file.put(static_cast<char>(10 * volume + i));
  }
  const auto range = [&](const char* file, const char* option, const char* n) {
    const RunResult result = callIsolux({"info", file, option, n, "--json"}, folder);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(result.out)["range"];
  };
  EXPECT_EQ(range("list.nrrd", "--time-step", "2"), (json{20.0, 27.0}));
  EXPECT_EQ(range("vector.nrrd", "--channel", "1"), (json{10.0, 17.0}));
  const RunResult beyond = callIsolux({"info", "list.nrrd", "--time-step", "3"}, folder);
  EXPECT_EQ(beyond.exitCode, 2);
  EXPECT_TRUE(beyond.isOneErrorLine()) << beyond.err;
}

}  // namespace
}  // namespace isolux::app
