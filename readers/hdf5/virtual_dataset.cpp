// Virtual datasets, as beamlines write them: many files with some slices each, put together by a table.
#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "readers/hdf5/candidates.h"
#include "readers/hdf5/dataset.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

namespace fs = std::filesystem;

using Axes = std::vector<std::uint64_t>;

// A box of a dataset.
struct Box {
  Axes low, size;
};

struct Source {
  std::string file, dataset;  // "": the file itself
  Box place, part;            // in the virtual dataset; in the source, all of it where that has no axes
};

// Nothing for a selection that is no box.
std::optional<Box> boxOf(hid_t space) {
  const int axes = ::H5Sget_simple_extent_ndims(space);
  if (axes < 1 || axes > static_cast<int>(kMostArrayAxes)) return std::nullopt;
  std::vector<hsize_t> low(static_cast<std::size_t>(axes)), high(low.size());
  if (::H5Sget_select_bounds(space, low.data(), high.data()) < 0) return std::nullopt;
  Box box{{low.begin(), low.end()}, {}};
  std::uint64_t count = 1;
  for (std::size_t axis = 0; axis < low.size(); ++axis) {
    box.size.push_back(high[axis] - low[axis] + 1);
    if (__builtin_mul_overflow(count, box.size.back(), &count)) return std::nullopt;
  }
  const hssize_t selected = ::H5Sget_select_npoints(space);
  if (selected < 0 || static_cast<std::uint64_t>(selected) != count) return std::nullopt;
  return box;
}

std::vector<Source> sourcesOf(hid_t properties, const std::string& name, const std::string& place) {
  constexpr std::size_t most = 1000;
  std::size_t count = 0;
  if (::H5Pget_virtual_count(properties, &count) < 0 || count == 0 || count > most)
    throwInput(name, place, "it is virtual and has no sources, or more than " + std::to_string(most));
  std::vector<Source> sources;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, 1024> file{}, dataset{};
    const Hdf5Handle to(::H5Pget_virtual_vspace(properties, i)),
        from(::H5Pget_virtual_srcspace(properties, i));
    const bool named = ::H5Pget_virtual_filename(properties, i, file.data(), file.size()) >= 0 &&
                       ::H5Pget_virtual_dsetname(properties, i, dataset.data(), dataset.size()) >= 0;
    if (!named || !to || !from) throwInput(name, place, "its sources cannot be told: " + hdf5Complaint());
    Source source{file.data(), dataset.data(), {}, {}};
    if (source.file == ".") source.file.clear();
    const auto box = boxOf(to.get());
    // The file does not keep how large a source is that is taken as a whole.
    const auto part =
        ::H5Sget_select_type(from.get()) == H5S_SEL_ALL ? std::optional(Box()) : boxOf(from.get());
    if (!box || !part)
      throwInput(name, place,
                 "it is made of parts of " + source.file + ":" + source.dataset +
                     " that are not boxes or are unlimited, which is not supported; open that");
    source.place = *box;
    source.part = *part;
    sources.push_back(std::move(source));
  }
  return sources;
}

// Axes of one entry are put before `axes`, or taken from its front, until there are `count`.
void fitAxes(Axes& axes, std::size_t count, std::uint64_t filled) {
  while (axes.size() > count) axes.erase(axes.begin());
  while (axes.size() < count) axes.insert(axes.begin(), filled);
}

class Assembly {
 public:
  Assembly(hid_t file, const std::string& name, Hdf5Table& table, base::Progress& progress)
      : file_(file), name_(name), table_(table), progress_(progress) {}

  void add(const Source& source) {
    const std::string where = source.file.empty() ? name_ : source.file;
    const hid_t file = source.file.empty() ? file_ : fileNamed(source.file);
    const Hdf5Handle dataset = openedObject(file, source.dataset);
    const auto candidate = dataset ? candidateOf(dataset.get(), source.dataset) : std::nullopt;
    if (!candidate) refuse(source, "is missing, or no numbers of two axes");
    Hdf5Table stored;
    stored.layout.dims = candidate->dims;
    stored.layout.dataset = source.dataset;
    stored.layout.number = candidate->number;
    readStored(dataset.get(), where, stored, progress_);
    const FileNumber &own = stored.layout.number, &wanted = table_.layout.number;
    if (own.type != wanted.type || own.half != wanted.half || own.big != wanted.big)
      refuse(source, "has another type than the whole");
    place(source, stored);
  }

 private:
  [[noreturn]] void refuse(const Source& source, const std::string& reason) const {
    throwInput(
        name_, table_.layout.dataset,
        "its source " + source.file + ":" + source.dataset + " " + reason + "; open the sources themselves");
  }

  hid_t fileNamed(const std::string& name) {
    if (const auto found = files_.find(name); found != files_.end()) return found->second.get();
    const fs::path path(name);
    const bool leaves =
        path.is_absolute() || std::ranges::any_of(path, [](const auto& part) { return part == ".."; });
    if (leaves)
      throwInput(name_, table_.layout.dataset, "its source " + name + " is outside the folder of the file");
    table_.layout.files.push_back(name);
    return files_.emplace(name, openedFile((fs::path(name_).parent_path() / path).string()))
        .first->second.get();
  }

  // The chunks of a source become those of the whole.
  void place(const Source& source, const Hdf5Table& stored) {
    Hdf5Layout& whole = table_.layout;
    const std::size_t axes = whole.dims.size();
    const Axes& extent = stored.layout.dims;
    Box part = source.part;
    if (part.size.empty()) part = {Axes(extent.size(), 0), extent};
    Axes chunk = stored.layout.chunk, low = part.low, size = part.size, dims = extent;
    const std::size_t extra = chunk.size() > axes ? chunk.size() - axes : 0;
    for (std::size_t axis = 0; axis < extra; ++axis)
      if (dims[axis] != 1) refuse(source, "has more axes than the whole");
    fitAxes(chunk, axes, 1);
    fitAxes(low, axes, 0);
    fitAxes(size, axes, 1);
    fitAxes(dims, axes, 1);
    if (size != source.place.size) refuse(source, "is put together in another shape");
    if (whole.chunk.empty()) {
      whole.chunk = chunk;
      whole.filters = stored.layout.filters;
      whole.contiguous = false;
      if (whole.chunkCount() > kMostHdf5Chunks) refuse(source, "has more than 16777216 chunks");
      table_.chunks.assign(static_cast<std::size_t>(whole.chunkCount()), Hdf5Chunk{});
    }
    if (chunk != whole.chunk || whole.filters != stored.layout.filters)
      refuse(source, "has other chunks than the first source");
    Axes count;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::uint64_t to = source.place.low[axis], n = size[axis];
      const bool whole_ = n % chunk[axis] == 0 || (to + n == whole.dims[axis] && low[axis] + n == dims[axis]);
      if (to % chunk[axis] != 0 || low[axis] % chunk[axis] != 0 || !whole_)
        refuse(source, "is cut within its chunks");
      count.push_back((n - 1) / chunk[axis] + 1);
    }
    copyChunks(source, stored, {low, dims}, count);
  }

  void copyChunks(const Source& source, const Hdf5Table& stored, const Box& from, const Axes& count) {
    const Hdf5Layout& whole = table_.layout;
    const std::uint64_t file =
        source.file.empty() ? 0
                            : 1 + static_cast<std::uint64_t>(std::ranges::find(whole.files, source.file) -
                                                             whole.files.begin());
    const std::uint64_t all =
        std::accumulate(count.begin(), count.end(), std::uint64_t{1}, std::multiplies<>());
    for (std::uint64_t i = 0; i < all; ++i) {
      std::uint64_t rest = i, to = 0, at = 0, toStride = 1, atStride = 1;
      for (std::size_t axis = count.size(); axis-- > 0;) {
        const std::uint64_t step = rest % count[axis], chunk = whole.chunk[axis];
        rest /= count[axis];
        to += (source.place.low[axis] / chunk + step) * toStride;
        at += (from.low[axis] / chunk + step) * atStride;
        toStride *= (whole.dims[axis] - 1) / chunk + 1;
        atStride *= (from.size[axis] - 1) / chunk + 1;
      }
      if (to >= table_.chunks.size() || at >= stored.chunks.size()) refuse(source, "is outside the whole");
      Hdf5Chunk& chunk = table_.chunks[static_cast<std::size_t>(to)];
      chunk = stored.chunks[static_cast<std::size_t>(at)];
      chunk.file = file;
    }
  }

  hid_t file_;
  const std::string& name_;
  Hdf5Table& table_;
  base::Progress& progress_;
  std::map<std::string, Hdf5Handle> files_;
};

}  // namespace

void addVirtual(hid_t file, hid_t properties, const std::string& name, Hdf5Table& table,
                base::Progress& progress) {
  const std::vector<Source> sources = sourcesOf(properties, name, table.layout.dataset);
  Assembly assembly(file, name, table, progress);
  for (const Source& source : sources) assembly.add(source);
  readFill(properties, table.layout);
}

}  // namespace isolux::readers
