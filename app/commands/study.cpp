// isolux study PATH --out DIR: what accuracy costs in time, as tables, JSON and plots.

#include "app/study/study.h"
#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/runtime/external_program.h"
#include "app/runtime/progress_bar.h"
#include "app/study_report/study_plot.h"
#include "app/study_report/study_report.h"
#include "base/error.h"
#include "base/words.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string path, out, qualities, size = "256x256";
  int repeat = 7;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

// Nothing that the study writes may be what it reads, say a session beside older results.
void checkOutputs(const fs::path& folder, const std::vector<QualitySetting>& chosen, OutputGuard guard) {
  for (const char* name : {"study.json", "study.md"}) guard.writes(folder / name, "--out");
  for (const QualitySetting& quality : chosen)
    guard.writes(folder / (std::string(quality.name) + ".svg"), "--out");
}

// Writes what is finished after every quality setting, so that a stop leaves it.
class StudyFolder {
 public:
  StudyFolder(fs::path folder, StudySubject subject, render::ContextDescription context)
      : folder_(std::move(folder)),
        subject_(std::move(subject)),
        context_(std::move(context)),
        gnuplot_(findProgram("gnuplot")) {
    if (gnuplot_.empty()) note_ = "no plots: they need gnuplot, which was not found (Debian: gnuplot-nox)";
  }

  void add(QualityStudy study, std::size_t of, base::Progress& progress) {
    if (!gnuplot_.empty() && study.skipped.empty()) {
      const std::string name = std::string(study.quality.name) + ".svg";
      std::string reason;
      if (writePlot(gnuplot_, study, subject_.volume->volume.name, folder_ / name, progress, reason))
        study.plot = name;
      else
        note_ = "no plot of " + std::string(study.quality.name) + ": " + reason;
    }
    if (!study.skipped.empty()) skipped_.emplace_back(study.quality.name);
    studies_.push_back(std::move(study));
    const bool complete = studies_.size() == of;
    writeTextFile(folder_ / "study.md", studyMarkdown(subject_, context_, studies_, complete));
    writeTextFile(folder_ / "study.json", studyJson(subject_, context_, studies_, complete));
  }

  const std::string& note() const { return note_; }
  std::string skipped() const { return base::joined(skipped_); }

 private:
  fs::path folder_;
  StudySubject subject_;
  render::ContextDescription context_;
  fs::path gnuplot_;
  std::vector<QualityStudy> studies_;
  std::string note_;                  // about plots that are not there
  std::vector<std::string> skipped_;  // quality settings
};

void runStudy(const StudyOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  const std::vector<QualitySetting> chosen = parseQualitySettings(options.qualities);
  const glm::ivec2 size = parseSize(options.size);
  const scene::Scene asked = sceneOf(options.path, *options.scene);
  checkOutputs(options.out, chosen, outputGuard(options.path, *options.scene, asked));
  const auto prepared = loadWithProgressBar(asked.source, progress);
  scene::Scene scene = sceneOf(options.path, *options.scene, *prepared);
  refuseCuts(scene, "isolux study");
  if (options.scene->camera.any())
    scene.camera = resolvedSceneOf(options.path, *options.scene, *prepared, size, progress).camera;
  const auto context = render::OffscreenContext::create(*options.context);
  const MadeFolder folder(options.out);
  const StudySubject subject{prepared, scene, hostSettingsOf(*options.scene), size, options.repeat};
  StudyFolder output(folder.path(), subject, context->description());
  StudyRunner studio(context->gl(), subject);
  {
    progress.report(0.0, "preparing");
    const ProgressBar bar(progress);
    studio.study(chosen, progress,
                 [&](QualityStudy study) { output.add(std::move(study), chosen.size(), progress); });
  }
  if (!output.note().empty()) printNote(output.note());
  if (!output.skipped().empty()) printNote("not studied (reasons in study.md): " + output.skipped());
  printWarnings(prepared->volume);
}

}  // namespace

Command makeStudy(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "study", "Measure error against time of each quality setting, for surfaces and light");
  auto options = std::make_shared<StudyOptions>();
  addPath(*parser, options->path, Opens::pictures);
  addOption(*parser, "--out", options->out, "DIR",
            "Folder for study.md, study.json and a plot per quality setting; created if missing")
      ->required();
  addOption(*parser, "--knobs,--settings", options->qualities, "LIST",
            "Study only these of " + base::joined(qualitySettings(), ",", &QualitySetting::name));
  addOption(*parser, "--size", options->size, "WxH", "Pixels of the image; default 256x256");
  addOption(*parser, "--repeat", options->repeat, "N", "Frames measured per value, in turns; default 7")
      ->check(within(1, 1000));
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  options->scene = addSceneOptions(*parser);
  addVolumeOptions(*parser, options->scene);
  parser->footer(
      "docs/explanation/accuracy.md explains the figures. Examples:\n"
      "  isolux study phantom:head --out head_study\n"
      "  isolux study ct.nii.gz --isovalue 300 --settings rate,method --size 512x512 --out hits\n"
      "  isolux study ct.nii.gz --preset ct_bone --view anterior --fit surface --out bone\n"
      "  isolux study picture.png --settings derivatives_field,fetch --out shapes\n"
      "  isolux study ct.nii.gz --set light.environment.file=probe.hdr --settings samples,interpolation "
      "--out light");
  return {parser, [options](base::Progress& progress) { runStudy(*options, progress); }};
}

}  // namespace isolux::app
