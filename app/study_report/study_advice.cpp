#include "app/study_report/study_advice.h"

#include <cmath>
#include <vector>

#include "app/study_report/study_table.h"

namespace isolux::app {

namespace {

using Rows = std::vector<const StudySetting*>;

// Rows of a quality setting as advice compares them: by the first panel.
class Comparing {
 public:
  explicit Comparing(const QualityStudy& study)
      : quality_(study.quality), panel_(panelsOf(study.quality)[0]) {}

  double error(const StudySetting& row) const { return panel_.error(judged(row)); }
  TimeSpread cost(const StudySetting& row) const { return costSpread(quality_, row, panel_); }
  bool missesNoMore(const StudySetting& a, const StudySetting& b) const {
    return judged(a).missed <= judged(b).missed;
  }
  bool moreAccurate(const StudySetting& a, const StudySetting& b) const {
    const double uncertain = std::hypot(uncertainty(a), uncertainty(b));
    return error(a) < 0.9 * error(b) && error(b) - error(a) > 2.0 * uncertain && missesNoMore(a, b);
  }
  bool asAccurate(const StudySetting& a, const StudySetting& b) const {
    return error(a) <= 1.1 * error(b) && missesNoMore(a, b);
  }
  bool cheaper(const StudySetting& a, const StudySetting& b) const {
    return cost(a).high < cost(b).low && cost(a).median < 0.9 * cost(b).median;
  }
  bool dearer(const StudySetting& a, const StudySetting& b) const { return cost(a).low > cost(b).high; }

  // "0.031 voxels (66 missed)"
  std::string errorOf(const StudySetting& row) const {
    std::string text = errorText(panel_, error(row));
    if (quality_.measure == Measure::hits) text += " (" + std::to_string(judged(row).missed) + " missed)";
    return text;
  }
  std::string costOf(const StudySetting& row) const { return costText(quality_, cost(row).median); }
  std::string noun() const { return panel_.noun; }

 private:
  double uncertainty(const StudySetting& row) const {
    return row.light ? row.errors.light.relative(row.errors.light.rmseStandardError) : 0.0;
  }

  const QualitySetting& quality_;
  const Panel& panel_;
};

std::string quoted(const std::string& text) {
  return '`' + text + '`';
}

std::string quotedSetting(const QualityStudy& study) {
  return quoted(study.quality.setting);
}

const StudySetting* defaultRow(const QualityStudy& study) {
  for (const StudySetting& row : study.settings)
    if (row.isDefault) return &row;
  return nullptr;
}

const StudySetting* rowNamed(const QualityStudy& study, const std::string& value) {
  for (const StudySetting& row : study.settings)
    if (row.value == value) return &row;
  return nullptr;
}

template <class Allowed, class Better>
const StudySetting* bestOf(const Rows& rows, const Allowed& allowed, const Better& better) {
  const StudySetting* best = nullptr;
  for (const StudySetting* const row : rows)
    if (allowed(*row) && (!best || better(*row, *best))) best = row;
  return best;
}

// How much dearer: "2.4 times the cost".
std::string timesTheCost(const Comparing& by, const StudySetting& a, const StudySetting& b) {
  const TimeSpread first = by.cost(a), second = by.cost(b);
  if (sameTime(first, second)) return "about the same cost";
  if (variesTooMuch(first) || variesTooMuch(second))
    return "a cost that varies too much for a ratio (" + by.costOf(a) + " against " + by.costOf(b) + ')';
  return tableNumber(first.median / second.median, 2) + " times the cost";
}

// Whether to leave the setting at `now`, of these rows.
std::string choiceAmong(const Comparing& by, const std::string& setting, const Rows& rows,
                        const StudySetting& now) {
  const auto lessError = [&](const StudySetting& a, const StudySetting& b) {
    return by.error(a) < by.error(b);
  };
  const auto lessCost = [&](const StudySetting& a, const StudySetting& b) {
    return by.cost(a).median < by.cost(b).median;
  };
  const auto accurate = [&](const StudySetting& row) { return by.moreAccurate(row, now); };
  if (const StudySetting* const gain = bestOf(
          rows, [&](const StudySetting& row) { return accurate(row) && !by.dearer(row, now); }, lessError))
    return "set " + setting + " to " + quoted(gain->value) + ": its " + by.noun() + " is " +
           by.errorOf(*gain) + " instead of " + by.errorOf(now) + ", and it costs no more (" +
           by.costOf(*gain) + " against " + by.costOf(now) + ").";
  if (const StudySetting* const gain = bestOf(
          rows, [&](const StudySetting& row) { return by.asAccurate(row, now) && by.cheaper(row, now); },
          lessCost))
    return "set " + setting + " to " + quoted(gain->value) + ": it is as accurate as " + quoted(now.value) +
           " and costs " + by.costOf(*gain) + " instead of " + by.costOf(now) + ".";
  std::string text = "leave " + setting + " at " + quoted(now.value) + ": ";
  if (const StudySetting* const next = bestOf(rows, accurate, lessCost))
    text += quoted(next->value) + " brings the " + by.noun() + " from " + by.errorOf(now) + " to " +
            by.errorOf(*next) + ", at " + timesTheCost(by, *next, now);
  else
    text += "no other value is more accurate than its " + by.errorOf(now);
  const auto worthIt = [&](const StudySetting& row) {
    return by.cheaper(row, now) && by.error(row) <= 4.0 * by.error(now);
  };
  const bool some = bestOf(
      rows, [&](const StudySetting& row) { return by.cheaper(row, now); }, lessError);
  if (const StudySetting* const less = bestOf(rows, worthIt, lessError))
    text += "; " + quoted(less->value) + " is cheaper (" + by.costOf(*less) + " instead of " +
            by.costOf(now) + "), with " + by.errorOf(*less);
  else
    text += some ? "; clearly cheaper values have more than four times the error"
                 : ", and none costs clearly less";
  return text + '.';
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string sampledAdvice(const QualityStudy& study, const Comparing& by) {
  Rows sampled;
  const StudySetting *exact = nullptr, *now = nullptr;
  for (const StudySetting& row : study.settings) {
    if (row.comparison) exact = &row;
    if (row.settingDefault || (row.isDefault && !row.comparison)) now = &row;
    if (!row.comparison) sampled.push_back(&row);
  }
  std::string text;
  if (exact) {
    const StudySetting* const rival = bestOf(
        sampled,
        [&](const StudySetting& row) { return by.asAccurate(row, *exact) && by.cheaper(row, *exact); },
        [&](const StudySetting& a, const StudySetting& b) { return by.cost(a).median < by.cost(b).median; });
    if (rival)
      text = "Sampling would do here: `hit.method=sampled` with " + quotedSetting(study) + " at " +
             quoted(rival->value) + " is as accurate as exact hits and costs " + by.costOf(*rival) +
             " instead of " + by.costOf(*exact) + ". ";
    else
      text = "Leave `hit.method` at `exact`, for which " + quotedSetting(study) +
             " has no use: exact hits have " + by.errorOf(*exact) + " in " + by.costOf(*exact) +
             ", and no value that is as accurate costs less. ";
  }
  if (now) text += "Where hits are sampled, " + choiceAmong(by, quotedSetting(study), sampled, *now);
  return text;
}

std::string fieldAdvice(const QualityStudy& study, const Comparing& by, const StudySetting& now) {
  const StudySetting* const through = rowNamed(study, "cubic_interpolating");
  if (!through || through == &now) return {};
  const std::string ratio = timesTheCost(by, *through, now);
  if (study.quality.measure == Measure::hits)
    return "Leave " + quotedSetting(study) + " at " + quoted(now.value) +
           " while the view moves: `cubic_interpolating` has " + ratio + ", and its surface lies " +
           by.errorOf(now) +
           " from this one (RMS). Pictures at rest take it by themselves where that matters "
           "(`picture.rest_hits`).";
  if (study.normalScaleMm > 0.0)
    return "Leave " + quotedSetting(study) + " at " + quoted(now.value) + ": at the normals' scale of " +
           tableNumber(study.normalScaleMm) + " mm `cubic_interpolating` has " + ratio +
           ", and the normals change by " + by.errorOf(now) + " (RMS).";
  return "Leave " + quotedSetting(study) + " at " + quoted(now.value) +
         " where samples are noisy, which it smooths and this table cannot judge; take `cubic_interpolating` "
         "for "
         "clean data: it has " +
         ratio + ", and the normals here change by " + by.errorOf(now) + " (RMS).";
}

std::string shadowAdvice(const QualityStudy& study, const Comparing& by) {
  const StudySetting *off = rowNamed(study, "0"), *on = rowNamed(study, "1");
  if (!off || !on) return {};
  std::string text = "Turn " + quotedSetting(study) + " on where the picture is the better for it: ";
  if (by.dearer(*on, *off))
    text += "a frame takes " + by.costOf(*on) + " instead of " + by.costOf(*off);
  else
    text += "it costs no time that can be told from the spread of frames (" + by.costOf(*on) + " against " +
            by.costOf(*off) + ")";
  return text + ", and the picture changes by " + by.errorOf(*off) +
         " in mean FLIP. Shadow rays are exact: no setting trades their accuracy for time.";
}

std::string scaleAdvice(const QualityStudy& study, const Comparing& by, const StudySetting& now) {
  const std::string leave = "Leave " + quotedSetting(study) + " at " + quoted(now.value) + ", which takes " +
                            tableNumber(now.scale.value().scaleMm) + " mm here: ";
  if (!study.knowsTruth)
    return leave +
           "a larger scale lets less noise through, but smooths away shape, which this table cannot count "
           "for "
           "a scan.";
  const StudySetting* best = &now;
  for (const StudySetting& row : study.settings)
    if (by.moreAccurate(row, *best)) best = &row;
  if (best == &now) return leave + "no other is clearly more accurate with this noise.";
  return leave +
         "it follows the noise of the phantom itself, not that which this study adds. With that noise " +
         quoted(best->value) + " times the mean spacing is the most accurate, with " + by.errorOf(*best) +
         " instead of " + by.errorOf(now) + ", at " + timesTheCost(by, *best, now) + '.';
}

}  // namespace

std::string adviceOf(const QualityStudy& study) {
  const Comparing by(study);
  if (study.quality.measure == Measure::shadow) return shadowAdvice(study, by);
  if (study.quality.sampled()) return sampledAdvice(study, by);
  const StudySetting* const now = defaultRow(study);
  if (!now || !std::isfinite(by.error(*now))) return "No recommendation: no pixel has a " + by.noun() + '.';
  if (study.quality.field())
    if (std::string text = fieldAdvice(study, by, *now); !text.empty()) return text;
  if (study.quality.measure == Measure::scale) return scaleAdvice(study, by, *now);
  Rows rows;
  for (const StudySetting& row : study.settings) rows.push_back(&row);
  return capitalized(choiceAmong(by, quotedSetting(study), rows, *now));
}

std::string noteOf(const QualityStudy& study) {
  if (!study.quality.sampled()) return {};
  const Comparing by(study);
  const StudySetting *finest = nullptr, *best = nullptr, *exact = nullptr;
  for (const StudySetting& row : study.settings) {
    if (row.comparison) {
      exact = &row;
      continue;
    }
    if (!best || by.error(row) < by.error(*best)) best = &row;
    finest = &row;
  }
  if (!exact || !finest || !(by.error(*finest) > 1.1 * by.error(*best)) ||
      !(by.error(*exact) < 0.5 * by.error(*finest)))
    return {};
  const char* const weights =
      study.eightBitVoxels ? "the texture unit reads these 8-bit voxels with filter weights of about 8 bits"
                           : "the texture unit's filter weights have about 8 bits on this machine";
  return "Sampled rows become worse with finer steps, from " + by.errorOf(*best) + " at " +
         quoted(best->value) + " to " + by.errorOf(*finest) + " at " + quoted(finest->value) + ": " +
         weights +
         ", so that a crossing is seen a little before or behind the true one. A short step then no longer "
         "holds the "
         "true crossing, and refining it has nothing to find. Exact hits use no filter.";
}

}  // namespace isolux::app
