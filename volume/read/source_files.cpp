#include "volume/read/source_files.h"

#include "base/error.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/text.h"
#include "volume/read/plain/meta_image.h"
#include "volume/read/plain/nrrd.h"
#include "volume/read/step_files.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestHeader = std::size_t{1} << 20;  // bytes

std::string headOf(const fs::path& file, std::size_t most) {
  try {
    return FileBytes(file).head(most);
  } catch (const base::Error&) {
    return {};
  }
}

bool isSlice(const fs::path& file) {
  const std::string extension = lowered(file.extension().string());
  return extension == ".dcm" || extension == ".tif" || extension == ".tiff" ||
         looksLikeDicom(headOf(file, kDicomHeadBytes));
}

void addSlicesOf(const fs::path& folder, int depth, std::vector<fs::path>& files) {
  std::error_code error;
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (fs::directory_iterator entry(folder, options, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && isSlice(entry->path())) files.push_back(entry->path());
    if (depth > 0 && entry->is_directory(ignored) && !entry->is_symlink(ignored))
      addSlicesOf(entry->path(), depth - 1, files);
  }
}

void addFilesUnder(const fs::path& folder, std::vector<fs::path>& files) {
  std::error_code error;
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(folder, options, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
}

// The data files that a MetaImage or NRRD header names.
std::vector<std::string> namesInHeader(const fs::path& file) {
  const std::string head = headOf(file, kLongestHeader);
  try {
    if (head.starts_with("NRRD0")) return parseNrrdHeader(head, file.string()).payload.files;
    if (looksLikeMetaImage(head))
      return parseMetaImageHeader(headOf(file, kLongestMetaImageHeader), file.string()).payload.files;
  } catch (const base::Error&) {  // damaged: nothing is read from it
  }
  return {};
}

// "scan.hdr" and "scan.img", each perhaps gzipped, belong together.
void addCounterparts(const fs::path& file, std::vector<fs::path>& files) {
  fs::path stem = file;
  if (lowered(stem.extension().string()) == ".gz") stem.replace_extension();
  const std::string extension = lowered(stem.extension().string());
  if (extension != ".hdr" && extension != ".img") return;
  for (const char* ending : {".hdr", ".hdr.gz", ".img", ".img.gz"}) {
    const fs::path candidate = fs::path(stem).replace_extension(ending);
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) files.push_back(candidate);
  }
}

}  // namespace

std::vector<fs::path> filesOfVolume(const std::string& path) {
  std::vector<fs::path> files;
  for (const std::string& step : stepFiles(path)) {
    const std::vector<fs::path> own = filesOfVolume(step);
    files.insert(files.end(), own.begin(), own.end());
  }
  if (!files.empty()) return files;
  fs::path file(path);
  if (!file.has_filename()) file = file.parent_path();  // "folder/"
  std::error_code ignored;
  if (const fs::path zarr = zarrFolderOf(file); !zarr.empty()) {
    addFilesUnder(zarr, files);
    return files;
  }
  if (const auto dataset = hdf5PathOf(path)) return {dataset->file};
  if (fs::is_directory(file, ignored)) {
    addSlicesOf(file, kDeepestDicomFolder, files);
    return files;
  }
  if (path.starts_with("phantom:") || !fs::is_regular_file(file, ignored)) return files;
  files.push_back(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (const std::string& name : namesInHeader(file))
    if (fs::is_regular_file(folder / name, ignored)) files.push_back(folder / name);
  addCounterparts(file, files);
  if (lowered(file.extension().string()) == ".dcm" || looksLikeDicom(headOf(file, kDicomHeadBytes)))
    addSlicesOf(folder, isDicomIndex(file) ? kDeepestDicomFolder : 1, files);
  return files;
}

}  // namespace isolux::volume
