#include "render/gl/gl_context.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <functional>
#include <optional>
#include <thread>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/error.h"
#include "base/memory_budget.h"
#include "render/gl/gl.h"

namespace isolux::render {

namespace {

using base::Error;
using base::ErrorKind;

[[noreturn]] void fail(const std::string& how, const std::string& reason) {
  throw Error(ErrorKind::graphics, "", how, reason);
}

// A shared library that stays open: Mesa's drivers do not survive being unloaded.
class Library {
 public:
  explicit Library(std::initializer_list<const char*> names, const std::string& how) {
    for (const char* name : names)
      if ((handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL))) return;
    fail(how, "the library " + std::string(*names.begin()) + " is not installed");
  }
  template <class F>
  F function(const char* name) const {
    return reinterpret_cast<F>(dlsym(handle_, name));
  }

 private:
  void* handle_ = nullptr;
};

// OSMesa. Declared here: <GL/osmesa.h> includes <GL/gl.h>, which cannot stand beside <GL/glcorearb.h>.
using OsMesaContext = void*;
using OsMesaProc = void (*)();
constexpr int osmesaFormat = 0x22, osmesaProfile = 0x33, osmesaCoreProfile = 0x34, osmesaMajor = 0x36,
              osmesaMinor = 0x37, osmesaRgba = 0x1908;

class OsMesa final : public OffscreenContext {
 public:
  OsMesa() : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}, "OSMesa") {
    const auto create =
        library_.function<OsMesaContext (*)(const int*, OsMesaContext)>("OSMesaCreateContextAttribs");
    makeCurrent_ = library_.function<decltype(makeCurrent_)>("OSMesaMakeCurrent");
    destroy_ = library_.function<decltype(destroy_)>("OSMesaDestroyContext");
    const auto procAddress = library_.function<OsMesaProc (*)(const char*)>("OSMesaGetProcAddress");
    if (!create || !makeCurrent_ || !destroy_ || !procAddress) fail("OSMesa", "the library is too old");
    const int attributes[] = {
        osmesaFormat, osmesaRgba, osmesaProfile, osmesaCoreProfile, osmesaMajor, 4, osmesaMinor, 5, 0};
    context_ = create(attributes, nullptr);
    if (!context_) fail("OSMesa", "no 4.5 core context");
    try {
      OsMesa::makeCurrent();
      load("OSMesa", [&](const char* name) { return reinterpret_cast<void*>(procAddress(name)); });
    } catch (...) {
      destroy_(context_);
      throw;
    }
  }
  ~OsMesa() override {
    if (context_) destroy_(context_);
  }
  void makeCurrent() override {
    constexpr unsigned unsignedByte = 0x1401;
    if (!makeCurrent_(context_, pixels_.data(), unsignedByte, 8, 8))
      fail("OSMesa", "cannot make the context current");
  }

 private:
  Library library_;
  unsigned char (*makeCurrent_)(OsMesaContext, void*, unsigned, int, int) = nullptr;
  void (*destroy_)(OsMesaContext) = nullptr;
  OsMesaContext context_ = nullptr;
  std::array<unsigned char, std::size_t{8} * 8 * 4> pixels_{};  // the default framebuffer nobody draws into
};

// EGL

struct Egl {
  explicit Egl(std::string kind) : how(std::move(kind)), library({"libEGL.so.1", "libEGL.so"}, how) {
    getProcAddress = library.function<decltype(getProcAddress)>("eglGetProcAddress");
    if (!getProcAddress) fail(how, "the library has no eglGetProcAddress");
  }
  template <class F>
  F get(const char* name) const {
    auto f = reinterpret_cast<F>(library.function<void*>(name));
    if (!f) f = reinterpret_cast<F>(getProcAddress(name));
    if (!f) fail(how, std::string("the library has no ") + name);
    return f;
  }
  std::string errorText() const {
    char text[32];
    std::snprintf(text, sizeof text, "error 0x%x", get<decltype(&eglGetError)>("eglGetError")());
    return text;
  }
  std::string how;  // for errors
  Library library;
  decltype(&eglGetProcAddress) getProcAddress;
};

class EglContext final : public OffscreenContext {
 public:
  // device < 0: the surfaceless platform.
  explicit EglContext(int device)
      : egl_(device < 0 ? "EGL surfaceless" : "EGL device " + std::to_string(device)) {
    const auto getDisplay = egl_.get<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (device < 0) {
      display_ = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    } else {
      const auto queryDevices = egl_.get<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
      std::array<EGLDeviceEXT, 16> devices{};
      EGLint count = 0;
      if (!queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) || device >= count)
        fail(egl_.how, "unknown device");
      display_ = getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(device)], nullptr);
    }
    EGLint major = 0, minor = 0;
    if (!display_ || !egl_.get<decltype(&eglInitialize)>("eglInitialize")(display_, &major, &minor))
      fail(egl_.how, "cannot be initialised, " + egl_.errorText());
    if (!egl_.get<decltype(&eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API))
      fail(egl_.how, "has no desktop OpenGL");
    const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    egl_.get<decltype(&eglChooseConfig)>("eglChooseConfig")(display_, configAttributes, &config, 1, &configs);
    if (configs < 1) config = EGL_NO_CONFIG_KHR;
    const EGLint contextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    context_ = egl_.get<decltype(&eglCreateContext)>("eglCreateContext")(display_, config, EGL_NO_CONTEXT,
                                                                         contextAttributes);
    if (!context_) fail(egl_.how, "no 4.5 core context, " + egl_.errorText());
    try {
      EglContext::makeCurrent();
      load(egl_.how, [&](const char* name) { return reinterpret_cast<void*>(egl_.getProcAddress(name)); });
    } catch (...) {
      release();
      throw;
    }
  }
  ~EglContext() override { release(); }
  void makeCurrent() override {
    if (!egl_.get<decltype(&eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                               context_))
      fail(egl_.how, "cannot make the context current without a surface, " + egl_.errorText());
  }

 private:
  void release() {
    egl_.get<decltype(&eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                          EGL_NO_CONTEXT);
    egl_.get<decltype(&eglDestroyContext)>("eglDestroyContext")(display_, context_);
    // The display is shared by the process and stays initialised.
  }
  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

int eglDeviceCount() {
  try {
    const Egl egl("EGL");
    const auto query = egl.get<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    return query(0, nullptr, &count) ? count : 0;
  } catch (const Error&) {
    return 0;
  }
}

struct Candidate {
  std::string kind;
  std::function<std::unique_ptr<OffscreenContext>()> make;
};

std::vector<Candidate> eglCandidates() {
  std::vector<Candidate> candidates;
  const int devices = eglDeviceCount();
  candidates.reserve(static_cast<std::size_t>(devices) + 1);
  for (int device = 0; device < devices; ++device)
    candidates.push_back(
        {"EGL device " + std::to_string(device), [device] { return std::make_unique<EglContext>(device); }});
  candidates.push_back({"EGL surfaceless", [] { return std::make_unique<EglContext>(-1); }});
  return candidates;
}

Candidate osmesaCandidate() {
  return {"OSMesa", [] { return std::make_unique<OsMesa>(); }};
}

// Software drivers end the process where memory for their code and threads is refused: they are asked for
// nothing where there is too little. Measured (Mesa 22.3, LLVM 15): 360 MiB of address space with 2 threads,
// a third of it touched.
void checkMemoryForDriver() {
  const std::size_t threads = std::clamp(std::thread::hardware_concurrency(), 1u, 32u);
  const std::size_t addresses = (std::size_t{400} + 16 * threads) << 20, touched = std::size_t{128} << 20;
  const auto refuse = [](std::size_t needed, std::size_t left, const char* remedy) {
    throw Error(ErrorKind::memory, "", "graphics",
                "OpenGL drivers would take " + base::memoryText(needed) + ", more than the " +
                    base::memoryText(left) + " that the system has left" + remedy);
  };
  if (const std::size_t left = base::addressSpaceLeft(); left < addresses)
    refuse(addresses, left, "; a higher limit of the address space (ulimit -v) helps");
  if (const std::size_t left = base::systemMemoryLeft(); left < touched) refuse(touched, left, "");
}

}  // namespace

void OffscreenContext::load(const std::string& kind, const std::function<void*(const char* name)>& loader) {
  gl_ = Gl::load(loader);
  description_ = {kind,
                  gl_->string(GL_VENDOR),
                  gl_->string(GL_RENDERER),
                  gl_->string(GL_VERSION),
                  gl_->string(GL_SHADING_LANGUAGE_VERSION),
                  gl_->software};
}

ContextChoice contextChoiceNamed(std::string_view name) {
  return name == "software" ? ContextChoice::software
         : name == "egl"    ? ContextChoice::egl
         : name == "osmesa" ? ContextChoice::osmesa
                            : ContextChoice::automatic;
}

std::unique_ptr<OffscreenContext> OffscreenContext::create(ContextChoice choice) {
  checkMemoryForDriver();
  std::string tried;
  const auto attempt = [&](const Candidate& candidate,
                           std::optional<bool> software) -> std::unique_ptr<OffscreenContext> {
    try {
      auto context = candidate.make();
      if (!software || *software == context->description().software) return context;
    } catch (const Error& error) {
      tried += (tried.empty() ? "" : "; ") + std::string(error.what());
    }
    return nullptr;
  };
  if (choice == ContextChoice::automatic)
    for (const Candidate& candidate : eglCandidates())
      if (auto context = attempt(candidate, false)) return context;
  if (choice != ContextChoice::egl) {
    if (auto context = attempt(osmesaCandidate(), {})) return context;
  }
  std::optional<bool> software;
  if (choice == ContextChoice::software) software = true;
  if (choice != ContextChoice::osmesa)
    for (const Candidate& candidate : eglCandidates())
      if (auto context = attempt(candidate, software)) return context;
  throw Error(ErrorKind::graphics, "", "no usable graphics context", tried);
}

std::vector<ContextProbe> probeContexts() {
  try {
    checkMemoryForDriver();
  } catch (const Error& error) {
    return {{"all", false, error.reason(), false}};
  }
  std::vector<Candidate> candidates = eglCandidates();
  candidates.push_back(osmesaCandidate());
  std::vector<ContextProbe> probes;
  std::vector<bool> software;
  for (const Candidate& candidate : candidates) {
    ContextProbe probe{candidate.kind, false, "", false};
    try {
      const auto context = candidate.make();
      probe.works = true;
      probe.detail = context->description().renderer + ", OpenGL " + context->description().version;
      software.push_back(context->description().software);
    } catch (const Error& error) {
      probe.detail = error.reason();
      software.push_back(true);
    }
    probes.push_back(std::move(probe));
  }
  // The order of create(automatic): hardware EGL, OSMesa, any EGL.
  const auto choose = [&](auto&& suits) {
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (probes[i].works && suits(i)) return probes[i].chosen = true;
    return false;
  };
  if (!choose([&](std::size_t i) { return !software[i]; }) &&
      !choose([&](std::size_t i) { return probes[i].kind == "OSMesa"; }))
    choose([](std::size_t) { return true; });
  return probes;
}

}  // namespace isolux::render
