// A renderer that draws one scene of one volume again and again, with the GL context of `gl` current.
#pragma once

#include <memory>

#include "bench/subjects.h"
#include "render/renderer.h"

namespace isolux::bench {

inline constexpr glm::ivec2 pictureSize{512, 512};  // pixels, of every section

struct Frame {
  Frame(const std::shared_ptr<const render::Gl>& gl, const VolumePointer& volume, scene::Scene wanted,
        int supersampling = 1, const scene::HostSettings& host = {})
      : renderer(std::make_shared<render::Renderer>(gl)),
        scene(scene::resolve(std::move(wanted), volume->facts)) {
    renderer->setHostSettings(host);
    renderer->setVolume(volume);
    request.size = pictureSize;
    request.supersampling = supersampling;
  }
  // Every pass.
  void operator()() const {
    renderer->invalidate();
    renderer->render(scene, request);
  }
  // What has changed since the last picture.
  const render::FrameReport& changed() const { return renderer->render(scene, request); }

  std::shared_ptr<render::Renderer> renderer;
  scene::Scene scene;
  render::FrameRequest request;
};

}  // namespace isolux::bench
