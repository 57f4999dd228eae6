// isolux study PATH --out DIR: what accuracy costs in time, as tables, JSON and plots.
#include <iostream>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/process/external_program.h"
#include "app/process/progress_bar.h"
#include "app/study/study.h"
#include "app/study_report/study_plot.h"
#include "app/study_report/study_report.h"
#include "base/error.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string path, out, knobs, size = "256x256";
  int repeat = 7;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

// Nothing that the study writes may be what it reads, say a session beside older results.
void checkOutputs(const fs::path& folder, const std::vector<Knob>& chosen, OutputGuard guard) {
  for (const char* name : {"study.json", "study.md"}) guard.writes(folder / name, "--out");
  for (const Knob& knob : chosen) guard.writes(folder / (std::string(knob.name) + ".svg"), "--out");
}

// Writes what is finished after every knob, so that a stop leaves it.
class StudyFolder {
 public:
  StudyFolder(fs::path folder, StudySubject subject)
      : folder_(std::move(folder)), subject_(std::move(subject)), gnuplot_(findProgram("gnuplot")) {
    if (gnuplot_.empty()) note_ = "no plots: they need gnuplot, which was not found (Debian: gnuplot-nox)";
  }

  void add(KnobStudy study, bool complete, base::Progress& progress) {
    if (!gnuplot_.empty() && study.skipped.empty()) {
      const std::string name = std::string(study.knob.name) + ".svg";
      std::string reason;
      if (writePlot(gnuplot_, study, subject_.volume->volume.name, folder_ / name, progress, reason))
        study.plot = name;
      else
        note_ = "no plot of " + std::string(study.knob.name) + ": " + reason;
    }
    if (!study.skipped.empty()) skipped_ += (skipped_.empty() ? "" : ", ") + std::string(study.knob.name);
    studies_.push_back(std::move(study));
    writeTextFile(folder_ / "study.md", studyMarkdown(subject_, studies_, complete));
    writeTextFile(folder_ / "study.json", studyJson(subject_, studies_, complete));
  }

  const std::string& note() const { return note_; }
  const std::string& skipped() const { return skipped_; }

 private:
  fs::path folder_;
  StudySubject subject_;
  fs::path gnuplot_;
  std::vector<KnobStudy> studies_;
  std::string note_;     // about plots that are not there
  std::string skipped_;  // knobs, by comma
};

void runStudy(const StudyOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  const std::vector<Knob> chosen = parseKnobs(options.knobs);
  const glm::ivec2 size = parseSize(options.size);
  const scene::Scene asked = sceneOf(options.path, *options.scene);
  checkOutputs(options.out, chosen, outputGuard(options.path, *options.scene, asked));
  const auto prepared = loadWithProgressBar(asked.source, progress);
  scene::Scene scene = sceneOf(options.path, *options.scene, *prepared);
  refuseCuts(scene, "isolux study");
  if (options.scene->camera.any())
    scene.camera = resolvedSceneOf(options.path, *options.scene, *prepared, size, progress).camera;
  const auto context = render::OffscreenContext::create(*options.context);
  context->makeCurrent();
  const MadeFolder folder(options.out);
  StudyFolder output(folder.path(), {prepared, scene::resolve(scene, prepared->facts), context->description(),
                                     size, options.repeat});
  Studio studio(context->gl(), prepared, scene, machineOf(*options.scene), size, options.repeat);
  {
    progress.report(0.0, "preparing");
    const ProgressBar bar(progress);
    double all = 0.0, done = 0.0;
    for (const Knob& knob : chosen) all += effortOf(knob, scene);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const double from = done / all;
      done += effortOf(chosen[i], scene);
      output.add(studio.study(chosen[i], progress, from, done / all), i + 1 == chosen.size(), progress);
    }
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
  parser->add_option(
      "PATH", options->path,
      "A volume file, a DICOM folder, phantom:NAME[:SIZE], a session, or a .png that carries one");
  parser
      ->add_option("--out", options->out,
                   "Folder for study.md, study.json and a plot per quality setting; created if missing")
      ->type_name("DIR")
      ->required();
  std::string known;
  for (const Knob& knob : knobs()) known += (known.empty() ? "" : ",") + std::string(knob.name);
  parser->add_option("--knobs,--settings", options->knobs, "Study only these of " + known)->type_name("LIST");
  parser->add_option("--size", options->size, "Pixels of the image; default 256x256")->type_name("WxH");
  parser->add_option("--repeat", options->repeat, "Frames measured per value, in turns; default 7")
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description(""));
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
