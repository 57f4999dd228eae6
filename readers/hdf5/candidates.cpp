#include "readers/hdf5/candidates.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "readers/hdf5/hdf5_handles.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

// A type of numbers that volumes have.
std::optional<FileNumber> numberOf(hid_t type) {
  const H5T_class_t kind = ::H5Tget_class(type);
  if (kind == H5T_ENUM) {  // h5py's bool
    const Hdf5Handle integer(::H5Tget_super(type));
    return integer ? numberOf(integer.get()) : std::nullopt;
  }
  const std::size_t bytes = ::H5Tget_size(type);
  const bool big = ::H5Tget_order(type) == H5T_ORDER_BE;
  if (kind == H5T_INTEGER && ::H5Tget_precision(type) == 8 * bytes) {
    const bool isSigned = ::H5Tget_sign(type) == H5T_SGN_2;
    switch (bytes) {
      case 1:
        return FileNumber{isSigned ? VoxelType::int8 : VoxelType::uint8, false, false};
      case 2:
        return FileNumber{isSigned ? VoxelType::int16 : VoxelType::uint16, false, big};
      case 4:
        return FileNumber{isSigned ? VoxelType::int32 : VoxelType::uint32, false, big};
      case 8:
        return FileNumber{isSigned ? VoxelType::int64 : VoxelType::uint64, false, big};
      default:
        return std::nullopt;
    }
  }
  const auto same = [&](hid_t known) { return ::H5Tequal(type, known) > 0; };
  if (same(H5T_IEEE_F32LE) || same(H5T_IEEE_F32BE)) return FileNumber{VoxelType::float32, false, big};
  if (same(H5T_IEEE_F64LE) || same(H5T_IEEE_F64BE)) return FileNumber{VoxelType::float64, false, big};
  if (kind == H5T_FLOAT && bytes == 2) {
    std::size_t sign = 0, exponent = 0, exponentBits = 0, fraction = 0, fractionBits = 0;
    if (::H5Tget_fields(type, &sign, &exponent, &exponentBits, &fraction, &fractionBits) >= 0 && sign == 15 &&
        exponent == 10 && exponentBits == 5 && fraction == 0 && fractionBits == 10)
      return FileNumber{VoxelType::float32, true, big};
  }
  return std::nullopt;
}

std::vector<std::uint64_t> dimsOf(hid_t dataset) {
  const Hdf5Handle space(::H5Dget_space(dataset));
  const int axes = space ? ::H5Sget_simple_extent_ndims(space.get()) : -1;
  if (axes < 1 || axes > static_cast<int>(kMostArrayAxes)) return {};
  std::vector<hsize_t> dims(static_cast<std::size_t>(axes));
  if (::H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr) < 0) return {};
  return {dims.begin(), dims.end()};
}

struct Search {
  std::vector<Candidate> found;
  std::size_t objects = 0;
};

herr_t lookAt(hid_t root, const char* name, const H5O_info_t* info, void* data) {
  auto& search = *static_cast<Search*>(data);
  constexpr std::size_t most = 100000, mostFound = 1000;
  if (++search.objects > most || search.found.size() >= mostFound) return 1;
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Hdf5Handle dataset(::H5Dopen2(root, name, H5P_DEFAULT));
  if (!dataset) return 0;
  const Hdf5Handle type(::H5Dget_type(dataset.get()));
  const auto number = type ? numberOf(type.get()) : std::nullopt;
  const std::vector<std::uint64_t> dims = dimsOf(dataset.get());
  const auto wide = std::count_if(dims.begin(), dims.end(), [](std::uint64_t n) { return n > 1; });
  if (!number || dims.size() < 2 || wide < 2 || std::count(dims.begin(), dims.end(), 0u) > 0) return 0;
  Candidate candidate{std::string("/") + name, dims, *number};
  candidate.voxels = 1.0;
  for (const std::uint64_t n : dims) candidate.voxels *= static_cast<double>(n);
  if (dims.size() < 3) candidate.voxels *= 1e-9;  // a picture only where there is no volume
  search.found.push_back(std::move(candidate));
  return 0;
}

}  // namespace

std::string describe(const Candidate& candidate) {
  std::string text = candidate.path + "\t" + candidate.path + ", ";
  for (std::size_t axis = 0; axis < candidate.dims.size(); ++axis)
    text += (axis > 0 ? " x " : "") + std::to_string(candidate.dims[axis]);
  return text + " " + std::string(candidate.number.half ? "float16" : nameOf(candidate.number.type));
}

std::vector<Candidate> candidatesOf(hid_t file, const std::string& name) {
  Search search;
  if (::H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, lookAt, &search, H5O_INFO_BASIC) < 0)
    throwInput(name, "", "the file is damaged: " + hdf5Complaint());
  if (search.found.empty())
    throwInput(name, "", "holds no dataset of numbers with at least two axes of more than one entry");
  std::stable_sort(search.found.begin(), search.found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.voxels > b.voxels; });
  return std::move(search.found);
}

const Candidate& chosenOf(const std::vector<Candidate>& candidates, const std::string& wanted,
                          const std::string& file) {
  if (wanted.empty()) return candidates.front();
  const std::string path = wanted.starts_with('/') ? wanted : "/" + wanted;
  for (const Candidate& candidate : candidates)
    if (candidate.path == path) return candidate;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 5); ++i)
    names += (i > 0 ? ", " : "") + candidates[i].path;
  throwInput(
      file, path,
      "there is no such dataset of numbers; the file has " + names + (candidates.size() > 5 ? ", ..." : ""));
}

}  // namespace isolux::readers
