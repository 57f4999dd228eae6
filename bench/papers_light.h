// The tables of Wyman et al. 2006 beside ours, as Markdown for docs/records/2026-11-paper-tables.md.
#pragma once

#include <filesystem>

#include "render/gl/gl_context.h"

namespace isolux::bench {

// Prints them; `data`: the folder with the engine block and the light probe. Takes minutes.
void printPapersLight(const render::OffscreenContext& context, const std::filesystem::path& data);

}  // namespace isolux::bench
