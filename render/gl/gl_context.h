// GL contexts without a window: EGL (a GPU without a display, or software) and OSMesa (software), chosen at
// run time. Both libraries are opened with dlopen, so the program starts where either is missing.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::render {

struct Gl;

// software: whichever of OSMesa and software EGL is there. Mesa has no OSMesa from 25.1 on.
enum class ContextChoice { automatic, software, egl, osmesa };
// "auto", "software", "egl" or "osmesa".
ContextChoice contextChoiceNamed(std::string_view name);

struct ContextDescription {
  std::string kind;  // "EGL device 0", "EGL surfaceless", "OSMesa", "Qt"
  std::string vendor, renderer, version, glsl;
  bool software = true;  // llvmpipe, softpipe, swrast
};

class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  virtual void makeCurrent() = 0;
  virtual const ContextDescription& description() const = 0;
  virtual std::shared_ptr<const Gl> gl() const = 0;

  // A current GL 4.5 core context. automatic: a hardware EGL device, else OSMesa, else software EGL;
  // software: the same without the first. Throws base::Error: memory where drivers would not find enough of
  // it, before any is loaded; graphics with what was tried and why each failed.
  static std::unique_ptr<OffscreenContext> create(ContextChoice choice);
};

// For `isolux doctor`: every way to a context, whether it worked, and which one automatic takes.
struct ContextProbe {
  std::string kind;
  bool works = false;
  std::string detail;  // renderer and version, or why not
  bool chosen = false;
};
std::vector<ContextProbe> probeContexts();

}  // namespace isolux::render
