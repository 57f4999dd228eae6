// isolux merge PART... --out FILE.vti: parts of a bake as the bake.
#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "gi/file/bake_file.h"
#include "gi/file/bake_merge.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

struct MergeOptions {
  std::vector<std::string> parts;
  std::string out;
  bool mixArithmetic = false, overwrite = false;
};

void runMerge(const MergeOptions& options, base::Progress& progress) {
  const fs::path out(options.out);
  if (out.extension() != ".vti") base::throwUsage(options.out, "", "the name of a bake must end in .vti");
  OutputGuard guard;
  for (const std::string& part : options.parts) guard.reads(part, "a part of the bake");
  checkOutput(guard, options.out, "--out");
  const OutputLock lock(options.out);
  std::error_code missing;
  if (!options.overwrite && fs::exists(out, missing) && !gi::looksLikeBakeFile(out))
    base::throwInput(options.out, "", "is not baked light; --overwrite replaces it");
  const ProgressBar bar(progress);
  const std::vector<fs::path> parts(options.parts.begin(), options.parts.end());
  gi::mergeBakeFiles(parts, out, options.mixArithmetic, progress);
}

}  // namespace

Command makeMerge(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("merge", "Join the parts of a light bake");
  auto options = std::make_shared<MergeOptions>();
  parser
      ->add_option("PART", options->parts, "Files of isolux bake --part: all parts of one bake, in any order")
      ->required();
  addOption(*parser, "--out", options->out, "FILE", "File to write (.vti): equals that of an undivided bake")
      ->required();
  parser->add_flag("--mix-arithmetic", options->mixArithmetic,
                   "Merge parts computed with and without fused multiply-add, whose last bits may differ; "
                   "the file records it");
  parser->add_flag("--overwrite", options->overwrite, "Replace --out even if it is not baked light");
  parser->footer(
      "Examples:\n"
      "  for i in 1 2 3; do isolux bake ct.nii.gz --out ct.vti --part $i/3; done\n"
      "  isolux merge ct.part-*.vti --out ct.vti");
  return {parser, [options](base::Progress& progress) { runMerge(*options, progress); }};
}

}  // namespace isolux::app
