// Computes what a scene's frames need of a volume in addition to its voxels, and its automatic values.
//
// These are fields (volume/derived/cubic_fields.h), scales of derivatives
// (volume/prepared/derivative_choices.h) and hidden components (volume/pieces). A background thread
// computes them; meanwhile frames are drawn with what is ready.
#pragma once

#include <memory>

#include "base/task.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Chooses automatic settings of derivatives and computes the fields that frames of the scene read, with its
// AOVs if `images`. Blocks until done.
void completeFields(scene::Scene& resolved, const volume::PreparedVolume& volume, bool images,
                    base::Progress& progress);

// Returns whether all that is ready for a frame of the scene, idle frames included
// (app/ready/rest_scene.h).
bool fieldsAreReady(const scene::Scene& resolved, const volume::PreparedVolume& volume);

// Returns the scene with what can be drawn now. Missing data are replaced: hits by those of the trilinear
// field, derivatives by those of the smoothing B-spline, scales by those of `last`, else by none; all
// components are shown. `last`: of the last frame of the volume for which everything was ready.
scene::Scene withReadyFields(scene::Scene resolved, const volume::PreparedVolume& volume,
                             const scene::Derivatives& last = {});

// Completes the fields of a resolved scene, those of idle frames included, on a background thread.
using FieldTask = base::Task<void>;
std::unique_ptr<FieldTask> fieldTask(std::shared_ptr<const volume::PreparedVolume> volume,
                                     scene::Scene resolved);
// Returns whether such a task of either scene completes the fields of the other.
bool needSameFields(const scene::Scene& a, const scene::Scene& b);

}  // namespace isolux::app
