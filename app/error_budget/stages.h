// Which combinations are measured, and how carefully: on more and more pixels until it is sure which one is
// taken. Only what decides is measured again: what surely keeps the limits, or surely does not, never is.
//
// Candidates are taken in their order, which is that of work, and the first that surely keeps the limits is
// the one chosen; so all of less work were measured as carefully as it takes to know that they do not.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/error_budget/choice.h"
#include "scene/scene.h"

namespace isolux::app {

// Throws what measuring throws; Error{interrupted} ends the search.
using MeasureCandidate = std::function<TargetErrors(const Candidate& candidate, Measuring measuring)>;
// `part` of the search is done, 0 to 1.
using Report = std::function<void(double part)>;

// On few pixels; on many, then most, where those leave open whether the limits are kept.
MeasuredCandidate measuredAsNeeded(const Candidate& candidate, std::span<const Limit> limits,
                                   const MeasureCandidate& measure);

// Of hits and derivatives. `list` is that of surfaceCandidates(); its first, the most exact one, is in
// `measured` already, and what is no cheaper than it is not measured where it keeps the limits. None: nothing
// does.
std::optional<std::size_t> chooseSurface(std::span<const Candidate> list, std::span<const Limit> limits,
                                         const MeasureCandidate& measure, const Report& report,
                                         std::vector<MeasuredCandidate>& measured);

// Of light. `list` is that of lightCandidates(), of changes of `given`. More paths are not tried on a lattice
// whose error would stay above the limit with any number of them, as far as two numbers of paths tell.
// What seems to keep the limit is measured on most pixels before it is taken. `measured` is added to. None:
// nothing keeps the limit.
std::optional<std::size_t> chooseLight(std::span<const Candidate> list, const scene::Scene& given,
                                       const Limit& limit, const MeasureCandidate& measure,
                                       const Report& report, std::vector<MeasuredCandidate>& measured);

}  // namespace isolux::app
