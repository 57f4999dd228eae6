// A study as study.json (docs/reference/outputs.md has its keys) and as study.md, a table per setting.
#pragma once

#include <string>
#include <vector>

#include "app/study/study.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

// `context`: what drew. `complete`: every quality setting that was asked for is there.
std::string studyJson(const StudySubject& subject, const render::ContextDescription& context,
                      const std::vector<QualityStudy>& studies, bool complete);
std::string studyMarkdown(const StudySubject& subject, const render::ContextDescription& context,
                          const std::vector<QualityStudy>& studies, bool complete);

}  // namespace isolux::app
