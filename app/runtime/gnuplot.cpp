#include "app/runtime/gnuplot.h"

#include "app/files/files.h"
#include "app/runtime/external_program.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// gnuplot does not look whether its output could be written.
bool isWholeSvg(const fs::path& file) {
  constexpr std::size_t longest = std::size_t{64} << 20;
  const std::string text = readTextFile(file, longest);
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  return end != std::string::npos && std::string_view(text).substr(0, end + 1).ends_with("</svg>");
}

}  // namespace

std::string gnuplotText(const std::string& text) {  // within single quotes only the quote itself is special
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

std::optional<std::string> drawPlot(const fs::path& gnuplot, const fs::path& picture,
                                    const std::function<std::string(const std::string& picture)>& script,
                                    base::Progress& progress) {
  PendingFile plot(picture);
  base::OutputFile file(fs::path(picture).replace_extension(".gp"));  // never committed: removed after use
  file.write(script(fs::absolute(plot.path()).string()));
  file.finish();
  const ProgramResult result =
      runProgram(gnuplot, {fs::absolute(file.path()).string()}, picture.parent_path(), progress);
  if (result.exitCode == 0) {
    if (!isWholeSvg(plot.path())) return "the plot is not whole (is the disk full?)";
    plot.commit();
    return std::nullopt;
  }
  return "gnuplot failed: " + result.lastLine();
}

}  // namespace isolux::app
