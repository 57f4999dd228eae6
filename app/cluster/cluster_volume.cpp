#include "app/cluster/cluster_volume.h"

#include <iterator>
#include <utility>
#include <variant>

#include "base/memory_budget.h"
#include "volume/read/process/wire.h"
#include "volume/voxels/stored_type.h"

namespace isolux::app {

namespace {

// In the order of volume::VoxelArray.
constexpr volume::VoxelType kStoredTypes[] = {volume::VoxelType::int8, volume::VoxelType::uint8,
                                              volume::VoxelType::int16, volume::VoxelType::uint16,
                                              volume::VoxelType::float32};

std::string headOf(const volume::Volume& volume) {
  const volume::Grid& grid = *volume.grid;
  volume::WireWriter out;
  for (int a = 0; a < 3; ++a) out.put(static_cast<std::uint64_t>(grid.dims()[a]));
  out.passFinite(grid.geometry().worldFromVoxel);
  out.put(grid.slope());
  out.put(grid.intercept());
  out.put(std::uint64_t{grid.voxels().index()});
  out.put(static_cast<std::uint64_t>(volume.axes));
  out.put(std::string_view(volume.name));
  out.put(std::string_view(volume.format));
  out.put(std::string_view(volume.unit));
  return out.bytes();
}

std::span<std::byte> bytesOfVoxels(volume::VoxelArray& voxels) {
  return std::visit([](auto& list) { return std::as_writable_bytes(std::span(list)); }, voxels);
}

}  // namespace

std::shared_ptr<const volume::PreparedVolume> broadcastVolume(
    Ranks& ranks, std::shared_ptr<const volume::PreparedVolume> volume, base::Progress& progress) {
  std::string head = volume ? headOf(volume->volume) : std::string();
  broadcastText(ranks, head, progress);
  if (volume) {  // sent, never written
    auto& voxels = const_cast<volume::VoxelArray&>(volume->grid().voxels());
    ranks.broadcast(bytesOfVoxels(voxels), progress);
    return volume;
  }
  volume::WireReader in(head);
  volume::GridGeometry geometry;
  constexpr std::uint64_t longest = std::uint64_t{1} << 30;
  for (int a = 0; a < 3; ++a) geometry.dims[a] = static_cast<int>(in.number(1, longest));
  in.passFinite(geometry.worldFromVoxel);
  const double slope = in.finite(), intercept = in.finite();
  const volume::VoxelType type = kStoredTypes[in.number(0, std::size(kStoredTypes) - 1)];
  volume::Volume received;
  received.axes = static_cast<scene::WorldAxes>(in.number(0, 2));
  received.name = in.text();
  received.format = in.text();
  received.unit = in.text();
  in.end();
  const std::size_t count = geometry.voxelCount();
  base::machineMemory().check(count * volume::bytesOf(type), "the volume that rank 0 sends", "");
  auto voxels = volume::withStoredType(
      type, [&](auto zero) { return volume::VoxelArray(std::vector<decltype(zero)>(count)); });
  ranks.broadcast(bytesOfVoxels(voxels), progress);
  received.grid = std::make_shared<volume::Grid>(geometry, std::move(voxels), slope, intercept, progress);
  return volume::prepareVolume(std::move(received), progress);
}

std::shared_ptr<const gi::Environment> broadcastProbe(Ranks& ranks,
                                                      std::shared_ptr<const gi::Environment> probe, int width,
                                                      int height, base::Progress& progress) {
  if (width == 0 || height == 0) return nullptr;
  std::vector<glm::vec3> pixels;
  if (probe)
    pixels = probe->pixels();
  else
    pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  ranks.broadcast(std::as_writable_bytes(std::span(pixels)), progress);
  if (probe) return probe;
  return std::make_shared<gi::Environment>(width, height, std::move(pixels));
}

}  // namespace isolux::app
