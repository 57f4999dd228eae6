#include "volume/read/hdf5/hdf5.h"

#include <numeric>
#include <utility>

#include "base/error.h"
#include "volume/read/hdf5/hdf5_layout.h"
#include "volume/read/process/reader_process.h"
#include "volume/read/process/wire.h"
#include "volume/read/zarr/ome.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

// The HDF Group's list of registered filters.
Codec codecOfFilter(const Hdf5Filter& filter, const FileNumber& number, const std::string& file,
                    const std::string& dataset) {
  if (filter.id == 2) {
    const std::size_t bytes = filter.values.empty() ? number.bytes() : filter.values.front();
    if (bytes < 1 || bytes > 256) throwInput(file, dataset, "the filter shuffle has no size of elements");
    return {CodecKind::shuffle, bytes};
  }
  static constexpr std::pair<std::uint32_t, CodecKind> kinds[] = {
      {1, CodecKind::deflate}, {3, CodecKind::fletcher32}, {307, CodecKind::bzip2},
      {32000, CodecKind::lzf}, {32001, CodecKind::blosc},  {32004, CodecKind::lz4Blocks},
      {32015, CodecKind::zstd}};
  for (const auto& [id, kind] : kinds)
    if (id == filter.id) return {kind, 1};
  // The library itself has the first three, so that h5repack undoes them; the others are plug-ins.
  static constexpr std::pair<std::uint32_t, const char*> known[] = {
      {4, "szip"}, {5, "nbit"}, {6, "scaleoffset"}, {32008, "bitshuffle"}, {32013, "zfp"}, {32026, "blosc2"}};
  std::string name = "number " + std::to_string(filter.id);
  for (const auto& [id, text] : known)
    if (id == filter.id) name = text;
  throwInput(
      file, dataset,
      "its chunks are packed by the filter " + name + ", which is not read; " +
          (filter.id < 7 ? "h5repack -f GZIP=1 FILE NEW changes it"
                         : "copy it with h5py after \"import hdf5plugin\", with compression=\"gzip\""));
}

// One dataset of an HDF5 file: its chunks, read from where the reader says that they lie.
class Hdf5Array final : public ChunkedArray {
 public:
  // `chunks`: layout.chunkCount() of them. Throws base::Error{input}, naming a filter that is not read.
  Hdf5Array(const fs::path& file, const Hdf5Layout& layout, std::vector<Hdf5Chunk> chunks)
      : layout_{layout.dims, layout.chunk, layout.number.type}, chunks_(std::move(chunks)) {
    files_.push_back(std::make_unique<FileBytes>(file));
    for (const std::string& other : layout.files) files_.push_back(openBeside(file)(other));
    format_.number = layout.number;
    format_.dims = layout.chunk;
    format_.order.resize(layout.chunk.size());
    std::iota(format_.order.begin(), format_.order.end(), std::size_t{0});
    format_.fill = layout.fill;
    for (const Hdf5Filter& filter : layout.filters)
      filters_.push_back(codecOfFilter(filter, layout.number, file.string(), layout.dataset));
    format_.codecs.assign(filters_.rbegin(), filters_.rend());
    checkChunkBytes(format_, file.string(), layout.dataset);
  }

  const ArrayLayout& layout() const override { return layout_; }
  bool plain() const override { return format_.codecs.empty(); }
  ArrayChunk read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                  std::span<const std::uint64_t> size) const override {
    std::uint64_t at = 0;
    for (std::size_t axis = 0; axis < index.size(); ++axis)
      at = at * ((layout_.dims[axis] - 1) / layout_.chunk[axis] + 1) + index[axis];
    const std::string place = chunkPlace(index);
    const Hdf5Chunk& chunk = chunks_[static_cast<std::size_t>(at)];
    if (chunk.size == 0) return missingChunk(format_);
    if (chunk.file >= files_.size()) throwBadAnswer("a chunk is in no file");
    const Bytes& bytes = *files_[static_cast<std::size_t>(chunk.file)];
    if (chunk.address > bytes.size() || chunk.size > bytes.size() - chunk.address)
      throwInput(bytes.name(), place, "truncated: beyond the end of the file");
    const ChunkFormat format = chunk.mask == 0 ? format_ : formatOf(chunk.mask);
    return readChunk(format, bytes, chunk.address, chunk.size, low, size, place);
  }

 private:
  ChunkFormat formatOf(std::uint64_t mask) const {
    ChunkFormat format = format_;
    format.codecs.clear();
    for (std::size_t i = filters_.size(); i-- > 0;)
      if ((mask >> i & 1u) == 0) format.codecs.push_back(filters_[i]);
    return format;
  }

  std::vector<std::unique_ptr<Bytes>> files_;  // the file itself, then layout.files
  ArrayLayout layout_;
  ChunkFormat format_;
  std::vector<Codec> filters_;  // in the order in which they were applied
  std::vector<Hdf5Chunk> chunks_;
};

}  // namespace

std::optional<Hdf5Path> hdf5PathOf(const std::string& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) {
    try {
      if (looksLikeHdf5(FileBytes(path))) return Hdf5Path{path, ""};
    } catch (const base::Error&) {  // who reads it will say why it cannot be
    }
    return std::nullopt;
  }
  for (std::size_t at = path.rfind(":/"); at != std::string::npos && at > 0; at = path.rfind(":/", at - 1)) {
    const fs::path file(path.substr(0, at));
    if (fs::is_regular_file(file, ignored)) return Hdf5Path{file, path.substr(at + 1)};
  }
  return std::nullopt;
}

bool looksLikeHdf5(const Bytes& bytes) {
  constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  for (std::uint64_t at = 0; at + signature.size() <= bytes.size() && at <= std::uint64_t{1} << 20;
       at = at == 0 ? 512 : 2 * at)
    if (bytes.text(at, signature.size()) == signature) return true;
  return false;
}

std::unique_ptr<ArrayVolume> openHdf5(const Hdf5Path& path, const std::string& series,
                                      base::Progress& progress) {
  const std::string name = path.file.string();
  Request request{.task = Task::chunks, .path = name};
  request.options.series = path.dataset.empty() ? series : path.dataset;
  request.options.budgetBytes = base::machineMemory().left();
  ReaderProcess reader(readerProgram("isolux-reader-hdf5"), request, progress);
  const Hdf5Layout layout = reader.announced(MessageKind::chunks, decodeHdf5Layout);
  reader.receive(bulkBytes(layout));
  std::vector<Hdf5Chunk> chunks(static_cast<std::size_t>(layout.chunkCount()));
  reader.read(0, std::as_writable_bytes(std::span(chunks)));
  reader.forgetMemory();
  const ArrayAxes axes = axesNamed(namesOf(layout.statements.axes), layout.dims, name, layout.dataset);
  ChunkedFacts facts;
  facts.name = name;
  facts.format = "HDF5";
  facts.levels.resize(1);
  applyStatements(layout.statements, axes, layout.dims, facts);
  facts.title = path.file.filename().string() + (path.dataset.empty() ? "" : ":" + path.dataset);
  if (path.dataset.empty()) facts.choices = layout.others;
  if (facts.choices.size() > 1 && series.empty())
    facts.warnings.push_back(std::to_string(facts.choices.size()) + " datasets; " + layout.dataset +
                             " is shown; source.series chooses another");
  return std::make_unique<ArrayVolume>(
      std::move(facts), axes,
      std::vector<std::shared_ptr<const ChunkedArray>>{valuesOf(
          std::make_shared<const Hdf5Array>(path.file, layout, std::move(chunks)), layout.statements)});
}

}  // namespace isolux::volume
