// Creates GL contexts without a window, chosen at run time: EGL (a GPU without a display, or software) and
// OSMesa (software).
//
// Both libraries are opened with dlopen, so the program starts if either is missing.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::render {

struct Gl;

// Kinds of context. software: OSMesa or software EGL, whichever exists. Mesa has no OSMesa from 25.1 on.
enum class ContextChoice { automatic, software, egl, osmesa };
// Parses "auto", "software", "egl" or "osmesa".
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
  const ContextDescription& description() const { return description_; }
  const std::shared_ptr<const Gl>& gl() const { return gl_; }

  // Creates a GL 4.5 core context and makes it current. automatic: a hardware EGL device, else OSMesa, else
  // software EGL; software: the same without the first. Throws base::Error: memory if drivers would lack
  // memory, before any is loaded; graphics with the contexts tried and the reason of each failure.
  static std::unique_ptr<OffscreenContext> create(ContextChoice choice);

 protected:
  // Sets both members from the context, which is current.
  void load(const std::string& kind, const std::function<void*(const char* name)>& loader);

  std::shared_ptr<const Gl> gl_;
  ContextDescription description_;
};

// Describes one way to create a context, for `isolux doctor`: whether it works, and whether `automatic`
// chooses it.
struct ContextProbe {
  std::string kind;
  bool works = false;
  std::string detail;  // renderer and version, or why not
  bool chosen = false;
};
std::vector<ContextProbe> probeContexts();

}  // namespace isolux::render
