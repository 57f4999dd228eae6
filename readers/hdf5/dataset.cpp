#include "readers/hdf5/dataset.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "base/error.h"
#include "readers/hdf5/candidates.h"
#include "readers/hdf5/hdf5_handles.h"
#include "readers/hdf5/recording_driver.h"
#include "readers/limits.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

hid_t memoryType(VoxelType type) {
  switch (type) {
    case VoxelType::int8:
      return H5T_NATIVE_INT8;
    case VoxelType::uint8:
      return H5T_NATIVE_UINT8;
    case VoxelType::int16:
      return H5T_NATIVE_INT16;
    case VoxelType::uint16:
      return H5T_NATIVE_UINT16;
    case VoxelType::int32:
      return H5T_NATIVE_INT32;
    case VoxelType::uint32:
      return H5T_NATIVE_UINT32;
    case VoxelType::int64:
      return H5T_NATIVE_INT64;
    case VoxelType::uint64:
      return H5T_NATIVE_UINT64;
    case VoxelType::float32:
      return H5T_NATIVE_FLOAT;
    case VoxelType::float64:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

std::vector<double> numbersOfAttribute(hid_t object, const char* name) {
  if (::H5Aexists(object, name) <= 0) return {};
  const Hdf5Handle attribute(::H5Aopen(object, name, H5P_DEFAULT));
  const Hdf5Handle space(attribute ? ::H5Aget_space(attribute.get()) : H5I_INVALID_HID);
  const hssize_t count = space ? ::H5Sget_simple_extent_npoints(space.get()) : 0;
  if (count < 1 || count > static_cast<hssize_t>(kMostArrayAxes)) return {};
  std::vector<double> values(static_cast<std::size_t>(count));
  if (::H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, values.data()) < 0) return {};
  return values;
}

// Of fixed or of variable length; empty where it is anything else.
std::vector<std::string> textsOfAttribute(hid_t object, const char* name) {
  if (::H5Aexists(object, name) <= 0) return {};
  const Hdf5Handle attribute(::H5Aopen(object, name, H5P_DEFAULT));
  const Hdf5Handle space(attribute ? ::H5Aget_space(attribute.get()) : H5I_INVALID_HID);
  const Hdf5Handle type(attribute ? ::H5Aget_type(attribute.get()) : H5I_INVALID_HID);
  const hssize_t count = space ? ::H5Sget_simple_extent_npoints(space.get()) : 0;
  if (!type || ::H5Tget_class(type.get()) != H5T_STRING || count < 1 ||
      count > static_cast<hssize_t>(kMostArrayAxes))
    return {};
  std::vector<std::string> texts;
  if (::H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> values(static_cast<std::size_t>(count), nullptr);
    if (::H5Aread(attribute.get(), type.get(), values.data()) < 0) return {};
    for (char* const value : values) {
      texts.emplace_back(value != nullptr ? value : "");
      ::H5free_memory(value);
    }
    return texts;
  }
  const std::size_t length = ::H5Tget_size(type.get());
  if (length > std::size_t{1} << 20) return {};
  std::string all(length * static_cast<std::size_t>(count), '\0');
  if (::H5Aread(attribute.get(), type.get(), all.data()) < 0) return {};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    texts.emplace_back(all.substr(i * length, length).c_str());
  return texts;
}

std::vector<Hdf5Filter> filtersOf(hid_t properties, const std::string& file, const std::string& place) {
  std::vector<Hdf5Filter> filters;
  const int count = ::H5Pget_nfilters(properties);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, values[64] = {};
    std::size_t valueCount = 64;
    const H5Z_filter_t id = ::H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &valueCount,
                                             values, 0, nullptr, nullptr);
    if (id < 0) throwInput(file, place, "its filters cannot be read: " + hdf5Complaint());
    Hdf5Filter filter{static_cast<std::uint32_t>(id), {}};
    filter.values.assign(values, values + std::min<std::size_t>(valueCount, 64));
    filters.push_back(std::move(filter));
  }
  return filters;
}

void readFill(hid_t properties, Hdf5Layout& layout) {
  H5D_fill_value_t defined = H5D_FILL_VALUE_UNDEFINED;
  if (::H5Pfill_value_defined(properties, &defined) < 0 || defined == H5D_FILL_VALUE_UNDEFINED) return;
  ::H5Pget_fill_value(properties, memoryType(layout.number.type), layout.fill.data());
}

void readStorage(hid_t properties, const std::string& file, Hdf5Layout& layout) {
  switch (::H5Pget_layout(properties)) {
    case H5D_CHUNKED: {
      std::vector<hsize_t> chunk(layout.dims.size());
      if (::H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) !=
          static_cast<int>(chunk.size()))
        throwInput(file, layout.dataset, "its chunks cannot be told: " + hdf5Complaint());
      layout.chunk.assign(chunk.begin(), chunk.end());
      layout.filters = filtersOf(properties, file, layout.dataset);
      break;
    }
    case H5D_CONTIGUOUS:
      if (::H5Pget_external_count(properties) > 0)
        throwInput(file, layout.dataset, "its voxels are in other files, which is not read");
      layout.contiguous = true;
      layout.chunk = layout.dims;
      break;
    case H5D_COMPACT:
      throwInput(file, layout.dataset, "it is stored in the file's header (compact), which is not read");
    case H5D_VIRTUAL:
      throwInput(file, layout.dataset, "it is made of other datasets (virtual), which is not read");
    default:
      throwInput(file, layout.dataset, "it is stored in a way that is not known");
  }
}

// Memory that the library takes for that of a chunk; the driver leaves it alone, so it costs nothing.
class UntouchedMemory {
 public:
  void* of(std::size_t bytes) {
    if (bytes > size_) {
      memory_.reset(std::malloc(bytes));
      if (!memory_) throw std::bad_alloc();
      size_ = bytes;
    }
    return memory_.get();
  }

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::unique_ptr<void, Free> memory_;
  std::size_t size_ = 0;
};

Hdf5Chunk chunkAt(hid_t dataset, const std::vector<hsize_t>& offset, UntouchedMemory& memory,
                  const std::string& file, const std::string& place) {
  hsize_t size = 0;
  if (::H5Dget_chunk_storage_size(dataset, offset.data(), &size) < 0) {
    const std::string complaint = hdf5Complaint();
    if (complaint.find("not allocated") != std::string::npos) return {};  // as HDF5 1.10 says "no such chunk"
    throwInput(file, place, "the table of its chunks is damaged: " + complaint);
  }
  if (size == 0) return {};
  constexpr hsize_t largest = hsize_t{1} << 32;  // by the format
  if (size > largest) throwInput(file, place, "a chunk is larger than 4 GiB");
  RecordedRead& record = recordedRead();
  record = {true, false, 0, 0};
  std::uint32_t mask = 0;
  const herr_t result =
      ::H5Dread_chunk(dataset, H5P_DEFAULT, offset.data(), &mask, memory.of(static_cast<std::size_t>(size)));
  record.recording = false;
  if (result < 0 || !record.happened || record.size != size)
    throwInput(file, place, "the table of its chunks is damaged: " + hdf5Complaint());
  return {record.address, size, mask};
}

std::vector<Hdf5Chunk> chunksOf(hid_t dataset, const Hdf5Layout& layout, const std::string& file,
                                base::Progress& progress) {
  if (layout.contiguous) {
    const haddr_t address = ::H5Dget_offset(dataset);
    if (address == HADDR_UNDEF) return {Hdf5Chunk{}};
    return {{address, static_cast<std::uint64_t>(::H5Dget_storage_size(dataset)), 0}};
  }
  const std::uint64_t count = layout.chunkCount();
  allowDecoding(count * sizeof(Hdf5Chunk));
  std::vector<Hdf5Chunk> chunks(static_cast<std::size_t>(count));
  std::vector<hsize_t> offset(layout.dims.size(), 0);
  UntouchedMemory memory;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (i % 1024 == 0) progress.report(static_cast<double>(i) / static_cast<double>(count), "reading");
    chunks[i] = chunkAt(dataset, offset, memory, file, layout.dataset);
    for (std::size_t axis = offset.size(); axis-- > 0;) {
      offset[axis] += layout.chunk[axis];
      if (offset[axis] < layout.dims[axis]) break;
      offset[axis] = 0;
    }
  }
  return chunks;
}

}  // namespace

Hdf5Table describeDataset(const std::filesystem::path& path, const ReadOptions& options,
                          base::Progress& progress) {
  silenceHdf5();
  const std::string name = path.string();
  const Hdf5Handle access(::H5Pcreate(H5P_FILE_ACCESS));
  if (!access || ::H5Pset_driver(access.get(), recordingDriver(), nullptr) < 0)
    throwInput(name, "", "the HDF5 library cannot be used: " + hdf5Complaint());
  const Hdf5Handle file(::H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.get()));
  if (!file) throwInput(name, "", "is no HDF5 file, or damaged: " + hdf5Complaint());
  allowHeaders(1000, 0);
  const std::vector<Candidate> candidates = candidatesOf(file.get(), name);
  const Candidate& chosen = chosenOf(candidates, options.series, name);
  const Hdf5Handle dataset(::H5Dopen2(file.get(), chosen.path.c_str(), H5P_DEFAULT));
  const Hdf5Handle properties(dataset ? ::H5Dget_create_plist(dataset.get()) : H5I_INVALID_HID);
  if (!properties) throwInput(name, chosen.path, "cannot be opened: " + hdf5Complaint());
  Hdf5Table table;
  Hdf5Layout& layout = table.layout;
  layout.dataset = chosen.path;
  layout.dims = chosen.dims;
  layout.number = chosen.number;
  for (const Candidate& candidate : candidates) layout.others.push_back(describe(candidate));
  readStorage(properties.get(), name, layout);
  readFill(properties.get(), layout);
  layout.elementSizeUm = numbersOfAttribute(dataset.get(), "element_size_um");
  layout.labels = textsOfAttribute(dataset.get(), "DIMENSION_LABELS");
  if (const auto tags = textsOfAttribute(dataset.get(), "axistags"); tags.size() == 1)
    layout.axisTags = tags[0];
  if (layout.chunkCount() > kMostHdf5Chunks)
    throwInput(name, layout.dataset, "has more than 16777216 chunks");
  table.chunks = chunksOf(dataset.get(), layout, name, progress);
  return table;
}

}  // namespace isolux::readers
