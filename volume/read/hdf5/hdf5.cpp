#include "volume/read/hdf5/hdf5.h"

#include "base/error.h"
#include "volume/read/hdf5/hdf5_array.h"
#include "volume/read/process/reader_process.h"
#include "volume/read/zarr/ome.h"

namespace isolux::volume {

namespace fs = std::filesystem;

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
  Request request;
  request.task = Task::chunks;
  request.path = path.file.string();
  request.options.series = path.dataset.empty() ? series : path.dataset;
  request.options.budgetBytes = base::machineMemory().left();
  ReaderProcess reader(readerProgram("isolux-reader-hdf5"), request, progress);
  const Hdf5Layout layout = reader.announced(MessageKind::chunks, decodeHdf5Layout);
  reader.receive(bulkBytes(layout));
  std::vector<Hdf5Chunk> chunks(static_cast<std::size_t>(layout.chunkCount()));
  reader.read(0, std::as_writable_bytes(std::span(chunks)));
  reader.forgetMemory();
  const std::string name = path.file.string();
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
