#include "tests/support/volumes.h"

#include "volume/phantom/phantom.h"

namespace isolux::test {

namespace {

volume::Grid made(const volume::PhantomRequest& request) {
  base::Progress progress;
  return volume::makePhantom(request, progress);
}

}  // namespace

volume::GridGeometry unitGeometry(glm::ivec3 dims) {
  return volume::GridGeometry::make(dims, glm::dvec3(1));
}

volume::Grid phantomGrid(const std::string& name, int size, double noise) {
  volume::PhantomRequest request;
  request.name = name;
  request.size = size;
  request.noise = noise;
  return made(request);
}

volume::Grid phantomGrid(const std::string& name, const volume::GridGeometry& geometry) {
  volume::PhantomRequest request;
  request.name = name;
  request.geometry = geometry;
  return made(request);
}

volume::Grid phantomGrid(const std::string& name, glm::ivec3 dims) {
  return phantomGrid(name, unitGeometry(dims));
}

std::shared_ptr<const volume::PreparedVolume> prepared(volume::Grid grid) {
  base::Progress progress;
  volume::Volume volume;
  volume.grid = std::make_shared<const volume::Grid>(std::move(grid));
  volume.name = "test";
  return volume::prepareVolume(std::move(volume), progress);
}

std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name, int size) {
  return prepared(phantomGrid(name, size));
}

std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name,
                                                      const volume::GridGeometry& geometry) {
  return prepared(phantomGrid(name, geometry));
}

}  // namespace isolux::test
