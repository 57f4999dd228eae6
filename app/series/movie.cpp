#include "app/series/movie.h"

#include "app/files/files.h"
#include "app/runtime/external_program.h"
#include "base/number_text.h"

namespace isolux::app {

namespace fs = std::filesystem;

std::string makeMovie(const fs::path& folder, const std::string& prefix, int frames, double fps,
                      const std::string& movie, base::Progress& progress) {
  const fs::path ffmpeg = findProgram("ffmpeg");
  if (ffmpeg.empty()) return "no " + movie + ": ffmpeg was not found";
  std::string pattern;  // a "%" of the prefix's own would be taken for a number's place
  for (const char c : prefix) pattern += c == '%' ? "%%" : std::string(1, c);
  PendingFile pending(folder / movie);
  // In the folder, by plain names, and not taken for options or protocols.
  const ProgramResult result =
      runProgram(ffmpeg,
                 {"-nostdin", "-loglevel", "error", "-y", "-framerate", base::shortestText(fps),
                  "-start_number", "0", "-i", "./" + pattern + "%05d.png", "-frames:v",
                  std::to_string(frames), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-f",
                  "mp4", fs::absolute(pending.path()).string()},
                 folder, progress);
  std::error_code missing;
  if (result.exitCode == 0 && fs::file_size(pending.path(), missing) > 0 && !missing) {
    pending.commit();
    return {};
  }
  return "no " + movie + ": ffmpeg failed (" + std::to_string(result.exitCode) + "): " + result.lastLine();
}

}  // namespace isolux::app
