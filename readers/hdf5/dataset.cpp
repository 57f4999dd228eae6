#include "readers/hdf5/dataset.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "base/error.h"
#include "readers/hdf5/candidates.h"
#include "readers/hdf5/conventions.h"
#include "readers/hdf5/recording_driver.h"
#include "readers/limits.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

hid_t memoryType(VoxelType type) {
  const hid_t types[] = {H5T_NATIVE_INT8,  H5T_NATIVE_UINT8,  H5T_NATIVE_INT16, H5T_NATIVE_UINT16,
                         H5T_NATIVE_INT32, H5T_NATIVE_UINT32, H5T_NATIVE_INT64, H5T_NATIVE_UINT64,
                         H5T_NATIVE_FLOAT, H5T_NATIVE_DOUBLE};
  return types[static_cast<int>(type)];
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
      throwInput(file, layout.dataset,
                 "it is stored in the file's header (compact), which is not read; h5repack -l CONTI FILE NEW "
                 "changes it");
    case H5D_VIRTUAL:
      throwInput(file, layout.dataset,
                 "it is made of other datasets (virtual) that are virtual themselves, which is not read");
    default:
      throwInput(file, layout.dataset, "its storage layout is unknown");
  }
}

// Memory that the library takes for that of a chunk; the driver leaves it alone, so it costs nothing.
class UntouchedMemory {
 public:
  void* of(std::size_t bytes) {
    if (bytes > size_) memory_ = std::make_unique_for_overwrite<std::byte[]>(size_ = bytes);
    return memory_.get();
  }

 private:
  std::unique_ptr<std::byte[]> memory_;
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

// Storage of the dataset at `path`, which has layout.dims, and its chunks behind those of the table.
void addDataset(hid_t file, const std::string& path, const std::string& name, Hdf5Table& table,
                base::Progress& progress) {
  const Hdf5Handle dataset = openedObject(file, path);
  const Hdf5Handle properties(dataset ? ::H5Dget_create_plist(dataset.get()) : H5I_INVALID_HID);
  if (!properties) throwInput(name, path, "cannot be opened: " + hdf5Complaint());
  if (::H5Pget_layout(properties.get()) == H5D_VIRTUAL)
    return addVirtual(file, properties.get(), name, table, progress);
  readStored(dataset.get(), name, table, progress);
}

// All of them as one array with two more axes, of times and channels, in chunks of one of each.
void addImaris(hid_t file, const ImarisImage& image, const std::string& name, Hdf5Table& table,
               base::Progress& progress) {
  Hdf5Layout& layout = table.layout;
  std::vector<std::uint64_t> chunk;
  for (const std::string& path : image.datasets) {
    const Hdf5Handle dataset = openedObject(file, path);
    const auto candidate = dataset ? candidateOf(dataset.get(), path) : std::nullopt;
    if (!candidate || candidate->dims != layout.dims || candidate->number.type != layout.number.type)
      throwInput(name, path, "is missing, or another size or type than the first channel");
  }
  const std::vector<std::uint64_t> padded = layout.dims;
  for (const std::string& path : image.datasets) {
    layout.dims = image.dims;
    const std::vector<Hdf5Filter> filters = std::exchange(layout.filters, {});
    addDataset(file, path, name, table, progress);
    if (layout.contiguous) layout.chunk = padded;
    layout.contiguous = false;
    if (!chunk.empty() && (chunk != layout.chunk || filters != layout.filters))
      throwInput(name, path, "its chunks are not those of the first channel");
    chunk = layout.chunk;
  }
  if (image.datasets.size() == 1) return;
  layout.dims.insert(layout.dims.begin(), {image.times, image.channels});
  layout.chunk.insert(layout.chunk.begin(), {1, 1});
  std::vector<AxisStatement> axes(2);
  axes[0].name = "t";
  axes[1].name = "c";
  layout.statements.axes.insert(layout.statements.axes.begin(), axes.begin(), axes.end());
  if (layout.chunkCount() > kMostHdf5Chunks)
    throwInput(name, layout.dataset, "has more than 16777216 chunks");
}

}  // namespace

void readFill(hid_t properties, Hdf5Layout& layout) {
  H5D_fill_value_t defined = H5D_FILL_VALUE_UNDEFINED;
  if (::H5Pfill_value_defined(properties, &defined) < 0 || defined == H5D_FILL_VALUE_UNDEFINED) return;
  ::H5Pget_fill_value(properties, memoryType(layout.number.type), layout.fill.data());
}

Hdf5Handle openedFile(const std::string& name) {
  const Hdf5Handle access(::H5Pcreate(H5P_FILE_ACCESS));
  if (!access || ::H5Pset_driver(access.get(), recordingDriver(), nullptr) < 0)
    throwInput(name, "", "the HDF5 library cannot be used: " + hdf5Complaint());
  Hdf5Handle file(::H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.get()));
  if (!file) throwInput(name, "", "is not an HDF5 file, or damaged: " + hdf5Complaint());
  return file;
}

void readStored(hid_t dataset, const std::string& name, Hdf5Table& table, base::Progress& progress) {
  const Hdf5Handle properties(::H5Dget_create_plist(dataset));
  if (!properties) throwInput(name, table.layout.dataset, "cannot be opened: " + hdf5Complaint());
  readStorage(properties.get(), name, table.layout);
  readFill(properties.get(), table.layout);
  if (table.layout.chunkCount() > kMostHdf5Chunks)
    throwInput(name, table.layout.dataset, "has more than 16777216 chunks");
  const std::vector<Hdf5Chunk> chunks = chunksOf(dataset, table.layout, name, progress);
  table.chunks.insert(table.chunks.end(), chunks.begin(), chunks.end());
}

Hdf5Table describeDataset(const std::filesystem::path& path, const ReadOptions& options,
                          base::Progress& progress) {
  silenceHdf5();
  const std::string name = path.string();
  const Hdf5Handle file = openedFile(name);
  allowHeaders(1000, 0);
  const std::vector<Candidate> candidates = candidatesOf(file.get(), name);
  const bool named = !options.series.empty();
  std::string wanted = named ? options.series : preferredOf(file.get());
  if (const Hdf5Handle object = openedObject(file.get(), wanted);
      !named && !candidateOf(object.get(), wanted))
    wanted.clear();
  Candidate chosen = chosenOf(file.get(), candidates, wanted, name);
  const ImarisImage imaris = imarisImage(file.get(), chosen, named);
  Hdf5Table table;
  Hdf5Layout& layout = table.layout;
  const FileNumber stored = chosen.number;
  layout.statements = statementsOf(file.get(), chosen, name);
  layout.dataset = chosen.path;
  layout.dims = chosen.dims;
  layout.number = stored;
  for (const Candidate& candidate : candidates) layout.others.push_back(describe(candidate));
  if (imaris.datasets.empty())
    addDataset(file.get(), chosen.path, name, table, progress);
  else
    addImaris(file.get(), imaris, name, table, progress);
  layout.number = chosen.number;  // perhaps without its sign: the same bytes
  return table;
}

}  // namespace isolux::readers
