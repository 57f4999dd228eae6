#include "volume/read/known_formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "volume/read/file_format.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

struct Known {
  std::string_view what, help;
};

std::string sentence(const Known& known) {
  return "is " + std::string(known.what) + ", which is not read; " + std::string(known.help);
}

// --- by content

struct Mark {
  std::size_t at;
  std::string_view bytes;
  Known known;
};

constexpr Known kMrtrix{"an MRtrix image", "`mrconvert FILE out.nii.gz` converts it"};
constexpr Known kMrc{"an MRC or CCP4 map", "`mrc2tif -s FILE out.tif` (IMOD) converts it"};
constexpr Known kCube{"a Gaussian cube file", "ParaView opens it and saves it as .vti"};
constexpr Known kSlc{"a volVis SLC file", "ParaView opens it and saves it as .vti"};
constexpr Known kMicroscope{"a microscope's own file",
                            "`bfconvert FILE out.ome.tif` (Bio-Formats) converts it"};
constexpr Known kNumpy{"a NumPy array", "save it as Zarr, HDF5 or NRRD"};
constexpr Known kAmira{"an Amira or Avizo file", "Amira exports it as NRRD or TIFF"};
constexpr Known kMeshScene{"a model of another format", "save the mesh as STL, OBJ or PLY"};
constexpr Known kTracks{"a list of tracks", "it holds no voxels"};
constexpr Known kPicture{"a single picture in a format",
                         "save the slices as TIFF (`mogrify -format tif FILES`)"};
constexpr Known kVdb{
    "an OpenVDB file",
    "copy its grid into an array with OpenVDB's Python module and save that as NRRD or Zarr"};
constexpr Known kNetCdf{"a classic netCDF file", "`nccopy -k netCDF-4 FILE out.nc` converts it"};
constexpr Known kGatan{"a Gatan file", "DigitalMicrograph or `bfconvert` (Bio-Formats) exports it as TIFF"};
constexpr Known kIsq{"a Scanco ISQ file", "ITKIOScanco converts it to MetaImage"};
constexpr Known kGltf{"a glTF model", "save the mesh as STL, OBJ or PLY"};
constexpr Known kAfni{"an AFNI dataset", "`3dAFNItoNIFTI FILE` converts it"};

constexpr Mark kMarks[] = {
    {0, "BZh"sv, {"packed with bzip2", "unpack it with `bunzip2 FILE`"}},
    {0,
     "\xfd"
     "7zXZ"sv,
     {"packed with xz", "unpack it with `unxz FILE`"}},
    {0, "7z\xbc\xaf"sv, {"a 7-Zip archive", "unpack it with `7z x FILE`"}},
    {0, "PK\3\4"sv, {"a ZIP archive", "unpack it with `unzip FILE`"}},
    {0, "\x28\xb5\x2f\xfd"sv, {"packed with zstd", "unpack it with `unzstd FILE`"}},
    {0, "\x04\x22\x4d\x18"sv, {"packed with LZ4", "unpack it with `unlz4 FILE`"}},
    {257, "ustar"sv, {"a tar archive", "unpack it with `tar xf FILE`"}},
    {0,
     "CDF\1"sv,
     {"a classic netCDF or MINC 1 file",
      "`nccopy -k netCDF-4 FILE out.nc` converts it (MINC: `mincconvert -2`)"}},
    {0, "CDF\2"sv, kNetCdf},
    {0, "CDF\5"sv, kNetCdf},
    {0, "mrtrix image"sv, kMrtrix},
    {0, "mrtrix tracks"sv, {"a list of MRtrix tracks", "it holds no voxels"}},
    {208, "MAP "sv, kMrc},
    {0, "11111\n"sv, kSlc},
    {0, " BDV"sv, kVdb},
    {0, "\x93NUMPY"sv, kNumpy},
    {0, "MATLAB 5.0"sv, {"a MATLAB 5 file", "save it with `save -v7.3`"}},
    {0, "# AmiraMesh"sv, kAmira},
    {0, "# Avizo"sv, kAmira},
    {0, "# HyperMesh"sv, kAmira},
    {0,
     "!INTERFILE"sv,
     {"an Interfile header", "open its data file as raw, with the size and type that this file states"}},
    {0, "#INRIMAGE-4"sv, {"an INRIMAGE volume", "convert it to NRRD or MetaImage"}},
    {0, "CTDATA-HEADER_V1"sv, kIsq},
    {0, "ncaa"sv, {"a Sunvision VFF volume", "convert it to NRRD or MetaImage"}},
    {0, "MATRIX72v"sv, {"an ECAT file", "`mri_convert` or TurkuPET's tools convert it to NIfTI"}},
    {0, "\x89PNG"sv, kPicture},
    {0, "\xff\xd8\xff"sv, kPicture},
    {0, "GIF8"sv, kPicture},
    {4, "jP  \r\n\x87\n"sv, kPicture},
    {0, "DVPE"sv, {"a Bruker file", "`dicomifier` or ParaVision converts it to DICOM"}},
    {0, "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, kMicroscope},  // compound files: .oib, .zvi, .txm, .xrm
    {0, "ZISRAWFILE"sv, kMicroscope},
    {0, "\xda\xce\xbe\x0a"sv, kMicroscope},  // .nd2
    {0, "\x0e\x03\x13\x01"sv, {"an HDF4 file", "`h4toh5 FILE out.h5` converts it to HDF5"}},
    {0, "P5\n"sv, kPicture},
    {0, "P6\n"sv, kPicture},
    {0, "IMGF"sv, {"an image of GE's scanners", "`dcm2niix FILE` may convert it"}},
    {0, "%PDF"sv, {"a PDF document", "it holds no voxels"}},
    {0, "glTF"sv, kGltf},
};

// Two lines of words, then "N x y z" and three axes, "n x y z" each, and N atoms of five numbers: that is all
// there is to tell it by.
bool looksLikeCube(std::string_view head) {
  Lines lines(head);
  for (int i = 0; i < 2; ++i)
    if (!lines.next()) return false;
  const auto row = [&] {
    const auto line = lines.next();
    return (line ? realsOf(*line) : std::nullopt).value_or(std::vector<double>{});
  };
  double atoms = 0.0;
  for (int i = 0; i < 4; ++i) {
    const std::vector<double> numbers = row();
    if (numbers.size() < 4 || numbers.size() > (i == 0 ? 5 : 4) || numbers[0] != std::trunc(numbers[0]))
      return false;
    if (i == 0) atoms = numbers[0];
  }
  return atoms == 0.0 || row().size() == 5;
}

// --- by name

constexpr std::pair<std::string_view, Known> kEndings[] = {
    {".head", kAfni},
    {".brik", kAfni},
    {".brik.gz", kAfni},
    {".mif", kMrtrix},
    {".mif.gz", kMrtrix},
    {".mih", kMrtrix},
    {".mrc", kMrc},
    {".ccp4", kMrc},
    {".slc", kSlc},
    {".cube", kCube},
    {".cub", kCube},
    {".npy", kNumpy},
    {".npz", kNumpy},
    {".mnc", {"a MINC file", "`mincconvert -2 FILE out.mnc` or `mnc2nii` converts it"}},
    {".vdb", kVdb},
    {".am", kAmira},
    {".czi", kMicroscope},
    {".lif", kMicroscope},
    {".nd2", kMicroscope},
    {".oir", kMicroscope},
    {".dm3", kGatan},
    {".dm4", kGatan},
    {".par", {"a Philips PAR/REC pair", "`dcm2niix FILE` converts it"}},
    {".vmr", {"a BrainVoyager volume", "BrainVoyager exports it as NIfTI"}},
    {".isq", kIsq},
    {".vgi",
     {"a VGStudio description", "open its .vol file as raw, with the size and type that this file states"}},
    {".gipl", {"a GIPL volume", "`c3d FILE -o out.nii.gz` (Convert3D) converts it"}},
    {".jp2", kPicture},
    {".gltf", kGltf},
    {".3mf", {"a 3MF model", "save the mesh as STL, OBJ or PLY"}},
    {".x3d", kMeshScene},
    {".wrl", kMeshScene},
    {".mz3", kMeshScene},
    {".gii", {"a GIFTI surface", "`mris_convert FILE out.stl` (FreeSurfer) converts it"}},
    {".annot", {"a FreeSurfer annotation", "it holds no voxels"}},
    {".trk", kTracks},
    {".trk.gz", kTracks},
    {".tck", kTracks},
    {".tck.gz", kTracks},
    {".tt", kTracks},
    {".tt.gz", kTracks},
    {".trx", kTracks},
    {".fib.gz", {"a DSI Studio file", "DSI Studio exports its maps as NIfTI"}},
};

bool isPicture(const fs::path& file) {
  const std::string ending = lowered(file.extension().string());
  constexpr std::array pictures = {".png", ".jpg", ".jpeg", ".bmp", ".jp2", ".gif", ".webp"};
  return std::ranges::find(pictures, ending) != pictures.end();
}

// Letters, digits and line breaks all through. Files named as raw voxels are believed.
bool looksLikeText(std::string_view head, const std::string& ending) {
  for (const char* raw : {".raw", ".bin", ".dat", ".img", ".vol"})
    if (ending == raw) return false;
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  return head.find('\n') != std::string_view::npos && std::ranges::all_of(head, [](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return byte >= 32 ? byte != 127 : c == '\n' || c == '\r' || c == '\t' || c == '\f';
         });
}

std::optional<Known> byContent(std::string_view head) {
  for (const Mark& mark : kMarks)
    if (head.size() > mark.at && head.substr(mark.at).starts_with(mark.bytes)) return mark.known;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> knownButNotRead(const Bytes& bytes, const fs::path& path) {
  constexpr std::size_t headBytes = 4096;
  const std::string head = bytes.head(headBytes);
  if (const auto known = byContent(head)) return sentence(*known);
  const std::string name = lowered(path.filename().string());
  for (const auto& [ending, known] : kEndings)
    if (name.ends_with(ending)) return sentence(known);
  if (head.starts_with("\x1f\x8b")) {
    const std::string inside = inflatedHead(bytes, headBytes);
    if (const auto known = byContent(inside)) return sentence(*known);
    const MemoryBytes content(bytes.name(), std::as_bytes(std::span(inside)));
    if (formatOf(content, path.stem()) == FileFormat::unknown)
      return sentence(
          {"packed with gzip",
           "no format is recognised in it; if these are raw voxels, unpack it with `gunzip FILE`"});
    return sentence({"packed with gzip", "unpack it with `gunzip FILE`"});
  }
  if (looksLikeCube(head)) return sentence(kCube);
  if (looksLikeText(head, lowered(path.extension().string())))
    return sentence({"a text file", "it names no volume format"});
  return std::nullopt;
}

std::optional<std::string> knownButNotReadIn(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (isPicture(entry.path()))
      return "the folder has pictures such as " + inQuotes(entry.path().filename().string()) +
             ", which are not read as slices; `mogrify -format tif FILES` makes TIFF files of them";
  return std::nullopt;
}

}  // namespace isolux::volume
