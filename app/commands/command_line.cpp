#include "app/commands/command_line.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <system_error>
#include <utility>

#include "app/commands/command.h"
#include "app/commands/made_pages.h"
#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "app/runtime/interrupt.h"
#include "app/runtime/thread_limit.h"
#include "app/version.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/words.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/step_files.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorKind;

struct WindowOptions {
  std::string path, record;
  std::shared_ptr<SceneOptions> scene;
};

// Everything the parser knows. Made and used within one runCommandLine().
struct Program {
  CLI::App parser{"Isolux explores scans and simulations as isosurfaces.", "isolux"};
  WindowOptions window;
  std::string madePage;
  std::vector<Command> commands;
};

void declare(Program& program, const std::function<std::string()>& describeWindow) {
  CLI::App& parser = program.parser;
  parser.get_formatter()->column_width(34);
  parser.set_version_flag("--version", "isolux " + std::string(version()), "Print the version and exit");
  parser
      .add_option("--made-page", program.madePage)  // for the build and the tests, not for --help
      ->group("")
      ->check(CLI::IsMember(madePageNames()));
  parser.require_subcommand(0, 1);
  parser.add_option("PATH", program.window.path,
                    "Open this in the window: a volume file, a DICOM folder, phantom:NAME[:SIZE], a session, "
                    "or a .png that carries one; default: the head phantom, or the session's volume");
  addOption(parser, "--record", program.window.record, "FILE",
            "Record every change in the window to this file, for replay");
  program.window.scene = addSceneOptions(parser);
  addVolumeOptions(parser, program.window.scene);
  addThreadsOption(parser);
  parser.footer(
      "Open a file that has the name of a subcommand as ./NAME. `isolux SUBCOMMAND --help` explains each.\n"
      "Exit codes: 0 success, 2 wrong command line, 3 unreadable input, 4 no graphics context, 5 out of "
      "memory,\n"
      "130 interrupted.\n\n"
      "Example:\n  isolux ct.nii.gz --isovalue 300");
  for (const auto make :
       {makeInfo, makeRender, makeBake, makeMerge, makeIndex, makeReference, makeReplay, makeStudy, makeProbe,
        makeMeasure, makeSlice, makeMesh, makePhantom, makePresets, makeSettings})
    program.commands.push_back(make(parser));
  program.commands.push_back(makeDoctor(parser, describeWindow));
  program.commands.push_back(makeHelp(parser));
  addMemoryOption(parser);
  for (const Command& command : program.commands) addMemoryOption(*command.parser);
}

// A lone word that is no file was meant as a subcommand.
void checkWord(const std::string& word, const Program& program) {
  std::error_code ignored;
  if (word.empty() || word.find_first_of("./:") != std::string::npos || fs::exists(word, ignored)) return;
  std::vector<std::string> names;
  for (const Command& command : program.commands) names.push_back(command.parser->get_name());
  base::throwUsage("", word,
                   "is neither a subcommand nor a file" +
                       base::didYouMean(word, names, "; `isolux --help` lists the subcommands"));
}

std::string firstLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  text = base::printable(std::move(text));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// "unknown option --otu, did you mean --out?" for the first word of the line that calls for it.
std::string mistypedOption(const CLI::App& used, int argc, char** argv) {
  std::vector<std::string> known;
  for (const CLI::Option* option : used.get_options())
    for (const std::string& name : option->get_lnames()) known.emplace_back("--").append(name);
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    word.resize(std::min(word.find('='), word.size()));
    if (!word.starts_with("--") || std::ranges::find(known, word) != known.end()) continue;
    if (const std::string hint = base::didYouMean(word, known, ""); !hint.empty())
      return "unknown option " + word + hint;
  }
  return {};
}

// The parser's complaint as one line, with the option that was probably meant.
Error usageError(const CLI::ParseError& error, const Program& program, int argc, char** argv) {
  const CLI::App* used = &program.parser;
  if (const auto chosen = program.parser.get_subcommands(); !chosen.empty()) used = chosen.front();
  std::string reason = mistypedOption(*used, argc, argv);
  if (reason.empty()) {
    const std::string command = used == &program.parser ? "isolux" : "isolux " + used->get_name();
    reason = firstLine(error.what()) + "; `" + command + " --help` explains";
  }
  return {ErrorKind::usage, "", "", reason};
}

// Parses; true when there is something to run (not when help or the version was printed).
bool parse(Program& program, int argc, char** argv) {
  try {
    program.parser.parse(argc, argv);
    return true;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      program.parser.exit(error, std::cout, std::cerr);
      return false;
    }
    if (program.parser.get_subcommands().empty()) {
      const std::vector<std::string> words = program.parser.get_option("PATH")->results();
      if (!words.empty()) checkWord(words.front(), program);
    }
    throw usageError(error, program, argc, argv);
  }
}

// What the window opens with, once the volume is there: automatic settings stay so, but for a camera that was
// wished for.
scene::Scene windowScene(const std::string& path, const SceneOptions& options,
                         const volume::PreparedVolume& volume, base::Progress& progress) {
  constexpr glm::ivec2 usual(4, 3);
  scene::Scene scene = sceneOf(path, options, volume);
  if (options.camera.any()) scene.camera = resolvedSceneOf(path, options, volume, usual, progress).camera;
  return scene;
}

int openWindowOn(const WindowOptions& options, const Program& program, const OpenWindow& openWindow) {
  if (program.parser.count("PATH") > 0) checkWord(options.path, program);
  WindowRequest request;
  request.scene = sceneOf(options.path, *options.scene);
  std::error_code ignored;  // a shell is the better place for this message than an empty window
  if (!options.path.empty() && !options.path.starts_with("phantom:") && !fs::exists(options.path, ignored) &&
      !volume::hdf5PathOf(options.path) && volume::stepFiles(options.path).empty())
    base::throwInput(options.path, "", "does not exist");
  if (!options.path.empty() && isRecording(options.path))
    base::throwInput(options.path, "",
                     "is a recording: `isolux replay " + options.path + " --out DIR` makes images of it");
  // A volume given beside a session makes another document, without a file of its own.
  const std::string session = options.path.empty() ? options.scene->session : options.path;
  if (!session.empty() && isSession(session))
    request.sessionFile = fs::absolute(session).lexically_normal().string();
  request.recordFile = options.record;
  if (options.scene->waitsForVolume())
    request.completed = [path = options.path, scene = *options.scene](const volume::PreparedVolume& volume) {
      base::Progress progress;
      return windowScene(path, scene, volume, progress);
    };
  hostSettingsOf(*options.scene);  // throws here, not in the window
  const auto& assignments = options.scene->assignments;
  std::ranges::copy_if(assignments, std::back_inserter(request.host), scene::isHostSetting);
  OutputGuard guard = outputGuard(options.path, *options.scene, request.scene);
  checkOutput(guard, options.record, "--record");
  if (!options.record.empty()) checkMayRecordInto(options.record);
  return openWindow(request);
}

void checkStandardOutput() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) base::throwInput("standard output", "", "cannot be written");
}

int report(const std::string& line, int exitCode) {
  std::cout.flush();
  const std::string text = "isolux: " + firstLine(line) + '\n';
  std::fputs(text.c_str(), stderr);
  return exitCode;
}

// Calls `body` and turns whatever it throws into one line and an exit code.
template <class Body>
int guarded(Body body, const std::function<bool(bool interrupted)>& mayReport) {
  std::string line;
  int exitCode = 0;
  try {
    return body();
  } catch (const Error& error) {
    line = error.kind() == ErrorKind::interrupted ? "interrupted" : error.what();
    exitCode = static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    line = "not enough memory";
    exitCode = static_cast<int>(ErrorKind::memory);
  } catch (const fs::filesystem_error& error) {
    // Only the question for the working folder fails without a path: it was deleted.
    line = Error(ErrorKind::input, error.path1().empty() ? "the working folder" : error.path1().string(), "",
                 error.code().message())
               .what();
    exitCode = static_cast<int>(ErrorKind::input);
  } catch (const std::system_error& error) {  // threads, above all
    line = "the system provides no more threads or memory: " + error.code().message();
    exitCode = static_cast<int>(ErrorKind::memory);
  } catch (const std::exception& error) {
    const bool refused = refusesThreads(error);
    line = refused
               ? "cannot create a thread; raise the process limit (ulimit -u)"
               : std::string("internal error: ") + error.what() + "; please report it with the command line";
    exitCode = refused ? static_cast<int>(ErrorKind::memory) : 1;
  }
  const bool interrupted = exitCode == static_cast<int>(ErrorKind::interrupted);
  return mayReport(interrupted) ? report(line, exitCode) : exitCode;
}

}  // namespace

int runCommandLine(int argc, char** argv, const OpenWindow& openWindow,
                   const std::function<std::string()>& describeWindow) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the limit of size is an error of its write, not the end
  return guarded(
      [&] {
        Program program;
        declare(program, describeWindow);
        if (!parse(program, argc, argv)) {
          checkStandardOutput();
          return 0;
        }
        if (!program.madePage.empty()) {
          std::cout << madePage(program.madePage, program.parser, std::string(version()));
          checkStandardOutput();
          return 0;
        }
        const auto chosen = std::ranges::find_if(
            program.commands, [](const Command& command) { return command.parser->parsed(); });
        if (chosen == program.commands.end()) return openWindowOn(program.window, program, openWindow);

        base::Progress progress;
        InterruptWatcher watcher(progress);
        const ThreadShare share = shareThreads();
        if (!share.note.empty()) std::fprintf(stderr, "isolux: note: %s\n", share.note.c_str());
        return guarded(
            [&] {
              chosen->run(progress);
              printThreadsNote(*chosen->parser);
              checkStandardOutput();
              return 0;
            },
            [&](bool interrupted) { return watcher.claimReport(interrupted); });
      },
      [](bool) { return true; });
}

}  // namespace isolux::app
