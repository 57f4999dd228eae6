// Holds what a study finds: the cost and the error of each value of a quality setting.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/study/quality_settings.h"
#include "app/study/study_errors.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Defines the subject of a study: a view of a scene.
struct StudySubject {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // as the user gave it
  scene::HostSettings host{};
  glm::ivec2 size{0};  // pixels
  int repeat = 3;      // frames of each setting
};

// A time that was measured over and over: its median and its quartiles.
struct TimeSpread {
  double median = 0.0, low = 0.0, high = 0.0;
};
// All NaN without a time. Between two times the low quartile is the lower one and the high quartile the upper
// one, so that the spread is no narrower than what was measured.
TimeSpread spreadOfTimes(std::vector<double> times);
// Their quartiles overlap: these measurements do not tell which is less.
bool sameTime(const TimeSpread& a, const TimeSpread& b);
// The quartiles are apart by a factor of 2 or more: too wide for a ratio.
bool variesTooMuch(const TimeSpread& spread);
// The time that the processor has worked on this process, all threads together, ms.
double processorMilliseconds();

// What stored light costs.
struct LightCost {
  double bakeSeconds = 0.0;            // median; NaN where its values share one bake
  double lookupMilliseconds = 0.0;     // pass irradiance, median
  std::uint64_t rays = 0, texels = 0;  // rays: 0 where the bake is shared
  std::uint64_t latticeBytes = 0, gpuBytes = 0;
  std::vector<double> bakeTimes{}, lookupTimes{};  // each measured one: s, ms
};

// What a field at a scale costs beside its pictures.
struct ScaleCost {
  double scaleMm = 0.0;
  double buildSeconds = 0.0;  // 0: none is built
  double unknown = 0.0;       // part of the surface's pixels whose curvature has a confidence below 1/2
};

struct StudySetting {
  std::string value;
  bool isDefault = false;          // what the program does unless told otherwise
  bool settingDefault = false;     // the setting's own default, which by default has no effect
  bool comparison = false;         // exact hits beside sampled ones
  double frameMilliseconds = 0.0;  // the picture of the scene's look, every pass run again
  std::map<std::string, double> passMilliseconds{};  // with gradient and hessian each run for themselves
  std::vector<double> frameTimes{};                  // ms, in the order of the frames, which medians are of
  std::map<std::string, std::vector<double>> passTimes{};
  // ms of processorMilliseconds() of the same frames, where a software driver draws; empty on a GPU.
  std::vector<double> processorTimes{};
  Errors errors{};                      // against double precision on the same fields
  std::optional<Errors> fieldErrors{};  // of a field: against cubic_interpolating in double precision
  std::optional<ScaleCost> scale{};  // of the quality setting of the scale; then only errors.noise is defined
  std::optional<LightCost> light{};  // of a quality setting of light; then only errors.light is defined
};

// Sets the medians of the times that the setting has by now.
void setMedians(StudySetting& setting);

struct QualityStudy {
  QualitySetting quality;
  std::vector<StudySetting> settings{};
  std::string plot{};  // file name beside study.json; "" where there is none
  bool eightBitVoxels = false;
  std::string skipped{};  // why it was not studied: it has no effect in this scene
  // The scale's study states the noise that was added, data units, and whether the truth is a phantom's own.
  double addedNoise = 0.0;
  bool knowsTruth = false;
  // Settings of derivatives state the scales of their default row, mm; 0: the field itself.
  double normalScaleMm = 0.0, curvatureScaleMm = 0.0;
  // Settings of light state what they were compared with.
  std::uint64_t truthSamples = 0;  // paths per pixel
  int truthBounces = 0;
};

// Returns what the panel shows its error against: the time of the passes that make it, or what the light
// costs.
double costOf(const QualitySetting& quality, const StudySetting& setting, const Panel& panel);
// The same with its quartiles; bytes have no spread.
TimeSpread costSpread(const QualitySetting& quality, const StudySetting& setting, const Panel& panel);
// What the setting is judged by: the errors of its field where it is a field, otherwise of its arithmetic.
const Errors& judged(const StudySetting& setting);
// The cheapest of the quality setting's rows, comparisons among them, whose first panel's error is at most
// this; of those whose cost its quartiles do not tell from it (sameTime) the most accurate. Null: none is.
const StudySetting* cheapest(const QualityStudy& study, double error);
// What cheapest() is asked for: of hits in voxels, of shapes in degrees, of scales in parts of the curvature,
// of light in parts of its mean, of edges in parts of the range of colours, of shadows in mean FLIP.
const std::array<double, 3>& errorsToReach(Measure measure);

// How many times as long as the processor worked its frames took, all of them together: above 1 where other
// programs kept the processor busy. NaN where a GPU draws.
double timesAsLong(const std::vector<QualityStudy>& studies);

}  // namespace isolux::app
