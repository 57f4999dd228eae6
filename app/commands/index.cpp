// isolux index PATH: the index beside a volume of which only parts are in memory.
#include <charconv>
#include <cstdio>
#include <optional>

#include "app/commands/command.h"
#include "app/process/progress_bar.h"
#include "base/error.h"
#include "base/memory_budget.h"
#include "volume/large/index_file.h"
#include "volume/read/open_chunked.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

constexpr int kMostIndexParts = 65536;

struct IndexOptions {
  std::string path, out, part;
  std::shared_ptr<SceneOptions> scene;
};

volume::IndexPart indexPartOf(const std::string& text) {
  volume::IndexPart part;
  if (text.empty()) return part;
  const char* const end = text.data() + text.size();
  const auto i = std::from_chars(text.data(), end, part.i);
  const bool slash = i.ec == std::errc() && i.ptr != end && *i.ptr == '/';
  const auto n = slash ? std::from_chars(i.ptr + 1, end, part.n) : i;
  if (!slash || n.ec != std::errc() || n.ptr != end || part.i < 1 || part.i > part.n ||
      part.n > kMostIndexParts)
    throw base::Error(base::ErrorKind::usage, "", "--part",
                      "\"" + text + "\" is not i/n, such as 2/5: part i of n, 1 <= i <= n");
  return part;
}

void runIndex(const IndexOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  const scene::Scene scene = sceneOf(options.path, *options.scene);
  const scene::Source& source = scene.source;
  const volume::IndexPart part = indexPartOf(options.part);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  std::string reason;
  const std::shared_ptr<const volume::ChunkedVolume> file = volume::openChunked(source, reason, progress);
  if (!file) base::throwInput(source.path, "", "has no use for an index, it is read whole: " + reason);
  const volume::IndexFile kept(source.path, volume::readOptions(source), options.out);
  std::optional<volume::VolumeIndex> index = kept.find(*file);
  const auto tellDamage = [&] {
    if (!index->damaged().empty())
      base::throwInput(source.path, "", volume::damageText(index->damaged()) + "; the index goes around");
  };
  if (index) {
    std::printf("%s is up to date\n", kept.place().c_str());
    return tellDamage();
  }
  fs::path written;
  {
    const ProgressBar bar(progress);
    written = kept.make(*file, part, index, progress);
  }
  std::printf("%s: %zu of %zu slabs, %s read\n", written.c_str(), index->unitsDone(), index->units(),
              base::memoryText(index->bytesRead()).c_str());
  tellDamage();
}

}  // namespace

Command makeIndex(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("index", "Index an out-of-core volume: value ranges of its bricks");
  auto options = std::make_shared<IndexOptions>();
  options->scene = addSceneOptions(*parser);
  parser->add_option(
      "PATH", options->path,
      "Raw, or NRRD, MetaImage, NIfTI and .vti (appended raw) without compression, OME-Zarr, HDF5");
  parser
      ->add_option("--out", options->out,
                   "Index file; default: PATH.index, or the user's cache if that folder is not writable. "
                   "Images look for it only there")
      ->type_name("FILE");
  parser
      ->add_option("--part", options->part,
                   "Index only part I of N, into FILE.part-I-of-N. The same command without --part joins the "
                   "existing parts, computes the rest and writes the index")
      ->type_name("I/N");
  parser->footer(
      "Examples:\n"
      "  isolux index big.nrrd\n"
      "  for i in 1 2 3; do isolux index big.nrrd --part $i/3 & done; wait; isolux index big.nrrd");
  return {parser, [options](base::Progress& progress) { runIndex(*options, progress); }};
}

}  // namespace isolux::app
