#include "readers/hdf5/candidates.h"

#include <algorithm>
#include <memory>
#include <set>

#include "base/error.h"
#include "base/words.h"
#include "readers/hdf5/hdf5_handles.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/text.h"

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
    const auto integer = integerType(bytes, ::H5Tget_sign(type) == H5T_SGN_2);
    return integer ? std::optional(FileNumber{*integer, false, big && bytes > 1}) : std::nullopt;
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

struct Link {
  std::shared_ptr<const Hdf5Handle> group;
  std::string name, path;
};

// Goes through the hard links of all groups; each object once. Objects are opened from their own group, so
// that deep ones take no longer than others (H5Ovisit's time grows with the square of the depth).
class Search {
 public:
  explicit Search(hid_t file) {
    links_.push_back({std::make_shared<const Hdf5Handle>(::H5Gopen2(file, "/", H5P_DEFAULT)), ".", ""});
  }

  void run() {
    constexpr std::size_t mostObjects = 100000, mostFound = 1000;
    while (!links_.empty() && objects_++ < mostObjects && found.size() < mostFound) {
      const Link link = std::move(links_.back());
      links_.pop_back();
      look(link);
    }
  }

  std::vector<Candidate> found;
  std::vector<std::string> external;  // "/path leads to FILE:/path", a few

 private:
  void look(const Link& link) {
    auto object =
        std::make_shared<const Hdf5Handle>(::H5Oopen(link.group->get(), link.name.c_str(), H5P_DEFAULT));
    H5O_info_t info{};
    if (!*object || ::H5Oget_info2(object->get(), &info, H5O_INFO_BASIC) < 0 ||
        !seen_.insert(info.addr).second)
      return;
    if (info.type == H5O_TYPE_DATASET) {
      if (auto candidate = candidateOf(object->get(), link.path)) found.push_back(std::move(*candidate));
    } else if (info.type == H5O_TYPE_GROUP) {
      const std::size_t first = links_.size();
      group_ = object;
      path_ = link.path;
      ::H5Literate(object->get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, addLink, this);
      std::reverse(links_.begin() + static_cast<std::ptrdiff_t>(first), links_.end());
    }
  }

  static herr_t addLink(hid_t group, const char* name, const H5L_info_t* info, void* data) {
    auto& search = *static_cast<Search*>(data);
    constexpr std::size_t most = 100000, mostNamed = 3;
    const std::string path = search.path_ + "/" + name;
    if (info->type == H5L_TYPE_HARD) search.links_.push_back({search.group_, name, path});
    if (info->type == H5L_TYPE_EXTERNAL && search.external.size() < mostNamed && !openedObject(group, name))
      search.external.push_back(path + " leads to " + externalTarget());
    return search.links_.size() < most ? 0 : 1;
  }

  std::vector<Link> links_;  // still to be followed, the next is the last
  std::set<haddr_t> seen_;
  std::size_t objects_ = 0;
  std::shared_ptr<const Hdf5Handle> group_;  // whose links are listed
  std::string path_;
};

}  // namespace

std::optional<Candidate> candidateOf(hid_t dataset, const std::string& path) {
  const Hdf5Handle type(::H5Dget_type(dataset));
  const auto number = type ? numberOf(type.get()) : std::nullopt;
  const std::vector<std::uint64_t> dims = dimsOf(dataset);
  const auto wide = std::ranges::count_if(dims, [](std::uint64_t n) { return n > 1; });
  if (!number || dims.size() < 2 || wide < 2 || std::ranges::count(dims, 0u) > 0) return std::nullopt;
  Candidate candidate{path, dims, *number};
  candidate.voxels = 1.0;
  for (const std::uint64_t n : dims) candidate.voxels *= static_cast<double>(n);
  if (dims.size() < 3) candidate.voxels *= 1e-9;  // a picture only where there is no volume
  return candidate;
}

std::string describe(const Candidate& candidate) {
  std::string text = candidate.path + "\t" + candidate.path + ", ";
  for (std::size_t axis = 0; axis < candidate.dims.size(); ++axis)
    text += (axis > 0 ? " x " : "") + std::to_string(candidate.dims[axis]);
  return text + " " + std::string(candidate.number.half ? "float16" : nameOf(candidate.number.type));
}

std::vector<Candidate> candidatesOf(hid_t file, const std::string& name) {
  Search search(file);
  search.run();
  if (search.found.empty() && !search.external.empty())
    throwInput(name, "", "holds no volume itself; " + base::joined(search.external) + ": open that file");
  std::ranges::stable_sort(search.found,
                           [](const Candidate& a, const Candidate& b) { return a.voxels > b.voxels; });
  return std::move(search.found);
}

Candidate chosenOf(hid_t file, const std::vector<Candidate>& candidates, const std::string& wanted,
                   const std::string& name) {
  const std::string path = wanted.empty() || wanted.starts_with('/') ? wanted : "/" + wanted;
  if (!path.empty()) {  // may lead through links that the search does not follow
    const Hdf5Handle object = openedObject(file, path);
    if (object && ::H5Iget_type(object.get()) == H5I_DATASET)
      if (auto candidate = candidateOf(object.get(), path)) return std::move(*candidate);
    if (!object && !externalTarget().empty())
      throwInput(name, path, "is a link to " + externalTarget() + ", another file: open that");
  }
  if (candidates.empty())
    throwInput(name, path, "holds no dataset of numbers with at least two axes of more than one entry");
  if (path.empty()) return candidates.front();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 5); ++i)
    names.push_back(candidates[i].path);
  throwInput(name, path,
             "unknown dataset of numbers; the file has " + base::joined(names) +
                 (candidates.size() > 5 ? ", ..." : ""));
}

}  // namespace isolux::readers
