// `isolux render --error` and `--time`: how they are given, and the search for the settings that keep them.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/error_budget/target_search.h"
#include "app/light/light_controller.h"

namespace isolux::app {

struct TargetOptions {
  std::string error, time;  // as on the command line; both empty: nothing is asked for
  bool any() const { return !error.empty() || !time.empty(); }
};
// `options` outlives the parser's callbacks.
void addTargetOptions(CLI::App& parser, TargetOptions& options);
// Throws Error{usage} where they make no sense: before any work.
void checkTarget(const TargetOptions& options);

// The settings that keep what was asked for; nothing, with a note on stderr, where nothing of the surface is
// seen. Throws as TargetSearch, and Error{usage} of a scene that cuts its first isosurface. `light` becomes
// that of the question's picture where frames are timed.
std::optional<TargetAnswer> chosenTarget(const TargetOptions& options, const TargetQuestion& question,
                                         render::Renderer& renderer, LightController& light,
                                         base::Progress& progress);

}  // namespace isolux::app
