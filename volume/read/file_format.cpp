#include "volume/read/file_format.h"

#include "volume/read/dicom/dicom_files.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/known_formats.h"
#include "volume/read/mesh/mesh.h"
#include "volume/read/plain/meta_image.h"
#include "volume/read/plain/mgh.h"
#include "volume/read/plain/nifti.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

std::string endingOf(const fs::path& path) {
  const std::string last = lowered(path.extension().string());
  return last == ".gz" ? lowered(path.stem().extension().string()) + last : last;
}

}  // namespace

FileFormat formatOf(const Bytes& bytes, const fs::path& path) {
  const std::string head = bytes.head(4096);
  const std::string extension = endingOf(path);
  if (looksLikeDicom(head)) return FileFormat::dicom;  // its first 128 bytes may be a TIFF header
  if (head.starts_with("NRRD0")) return FileFormat::nrrd;
  if (head.starts_with("# vtk DataFile")) return FileFormat::vtkLegacy;
  if (isMesh(head, extension)) return FileFormat::mesh;
  if (head.find("<VTKFile") != std::string::npos) return FileFormat::vti;
  if (looksLikeTiff(head)) return FileFormat::tiff;
  if (looksLikeNifti(head)) return FileFormat::nifti;
  if (looksLikeMgh(head)) return FileFormat::mgh;
  if (isPacked(head)) {
    const std::string inside = inflatedHead(bytes, niftiHeaderBytes);
    if (looksLikeNifti(inside)) return FileFormat::nifti;
    if (looksLikeMgh(inside)) return FileFormat::mgh;
  }
  if (looksLikeMetaImage(head)) return FileFormat::metaImage;
  if (extension == ".mhd" || extension == ".mha") return FileFormat::metaImage;
  if (extension == ".nrrd" || extension == ".nhdr") return FileFormat::nrrd;
  if (extension == ".nii" || extension == ".nii.gz" || extension == ".hdr" || extension == ".hdr.gz")
    return FileFormat::nifti;
  if (extension == ".mgz" || extension == ".mgh" || extension == ".mgh.gz") return FileFormat::mgh;
  if (extension == ".vtk") return FileFormat::vtkLegacy;
  if (extension == ".vti") return FileFormat::vti;
  if (extension == ".tif" || extension == ".tiff") return FileFormat::tiff;
  if (extension == ".dcm") return FileFormat::dicom;
  if ((extension == ".img" || extension == ".img.gz") && !counterpart(path, ".hdr").empty())
    return FileFormat::nifti;
  return FileFormat::unknown;
}

}  // namespace isolux::volume
