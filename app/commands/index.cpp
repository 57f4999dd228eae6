// isolux index PATH: the index beside a volume of which only parts are in memory.
#include <cstdio>
#include <optional>
#include <tuple>

#include "app/commands/command.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "volume/large/index_file.h"
#include "volume/read/volume_file.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

constexpr int kMostIndexParts = 65536;

struct IndexOptions {
  std::string path, out, part;
  std::shared_ptr<SceneOptions> scene;
};

void runIndex(const IndexOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  const scene::Scene scene = sceneOf(options.path, *options.scene);
  const scene::Source& source = scene.source;
  volume::IndexPart part;
  if (!options.part.empty()) std::tie(part.i, part.n) = parsePart(options.part, kMostIndexParts);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  const volume::VolumeFile opened = volume::openSource(source, progress);
  const std::shared_ptr<const volume::ChunkedVolume>& file = opened.parts;
  if (!file)
    base::throwInput(source.path, "", "has no use for an index, it is read whole: " + opened.whyWhole);
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
      "Raw, or NRRD, MetaImage, NIfTI, MGH and .vti (appended raw) without compression, OME-Zarr, HDF5");
  addOption(*parser, "--out", options->out, "FILE",
            "Index file; default: PATH.index, or the user's cache if that folder is not writable. Images "
            "look for it only there");
  addOption(*parser, "--part", options->part, "I/N",
            "Index only part I of N, into FILE.part-I-of-N. The same command without --part joins the "
            "existing parts, computes the rest and writes the index");
  parser->footer(
      "Examples:\n"
      "  isolux index big.nrrd\n"
      "  for i in 1 2 3; do isolux index big.nrrd --part $i/3 & done; wait; isolux index big.nrrd");
  return {parser, [options](base::Progress& progress) { runIndex(*options, progress); }};
}

}  // namespace isolux::app
