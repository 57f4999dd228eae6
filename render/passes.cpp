#include "render/passes.h"

#include <cstring>

namespace isolux::render {

namespace {

// FNV-1a over the bytes of plain values.
class Hasher {
 public:
  template <class T>
  Hasher& add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3ull;
    return *this;
  }
  Hasher& add(const glm::dvec3& v) { return add(v.x).add(v.y).add(v.z); }
  Hasher& add(const std::optional<glm::dvec3>& v) { return v ? add(true).add(*v) : add(false); }
  operator std::uint64_t() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace

std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           std::uint64_t volumeHash) {
  const scene::Look& look = scene.look;
  const Parameter volume{"volume", Hasher().add(volumeHash)};
  const Parameter isovalue{"isovalue", Hasher().add(scene.isosurface.value.value_or(0.0))};
  const Parameter camera{"camera", Hasher()
                                       .add(scene.camera.eye)
                                       .add(scene.camera.target)
                                       .add(scene.camera.up)
                                       .add(scene.camera.fov)
                                       .add(scene.camera.projection)};
  const Parameter size{"picture size",
                       Hasher().add(request.size.x).add(request.size.y).add(request.supersampling)};
  const Parameter method{"hit.method", Hasher().add(scene.hit.method)};
  const bool sampled = scene.hit.method == scene::HitMethod::sampled;
  // A setting is a parameter only where it acts: hit.rate does nothing for exact hits.
  const Parameter rate{"hit.rate", Hasher().add(sampled ? scene.hit.rate : 0.0)};
  const Parameter refinements{"hit.refinements", Hasher().add(sampled ? scene.hit.refinements : -1)};
  const Parameter field{"derivatives.field", Hasher().add(scene.derivatives.field)};

  const bool needsGradient = look.mode != scene::LookMode::depth;
  const bool lit = look.mode == scene::LookMode::blinn_phong || look.mode == scene::LookMode::lambert;
  Hasher lookHash;
  lookHash.add(look.mode).add(look.backgroundTop).add(look.backgroundBottom);
  if (lit) {
    lookHash.add(look.ambient)
        .add(scene.isosurface.albedo)
        .add(scene.light.direction)
        .add(scene.light.intensity);
    if (look.mode == scene::LookMode::blinn_phong) lookHash.add(look.specular).add(look.shininess);
  }
  if (needsGradient) lookHash.add(scene.isosurface.inside);

  std::vector<PassDeclaration> passes = {
      {pass::blocks, {}, {image::activeBlocks, image::faces}, {volume, isovalue}},
      {pass::segments, {image::activeBlocks, image::faces}, {image::segments}, {camera, size}},
      {pass::cast,
       {image::activeBlocks, image::segments},
       {image::bracket},
       {volume, isovalue, camera, size, method, rate}},
      {pass::refine, {image::bracket}, {image::surface}, {volume, isovalue, camera, size, refinements}},
      {pass::gradient, {image::surface}, {image::gradient}, {volume, field}},
      {pass::shade, {image::surface}, {image::color}, {camera, {"look", lookHash}}},
      {pass::resolve, {image::color}, {image::picture}, {size}},
  };
  if (needsGradient) passes[5].reads.push_back(image::gradient);
  return passes;
}

std::vector<std::string> wantedImages(const FrameRequest& request) {
  std::vector<std::string> wanted;
  if (request.color) wanted.emplace_back(image::picture);
  for (const Aov aov : request.aovs)
    wanted.emplace_back(aov == Aov::normal || aov == Aov::gradient ? image::gradient : image::surface);
  return wanted;
}

}  // namespace isolux::render
