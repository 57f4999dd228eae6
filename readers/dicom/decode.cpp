#include "readers/dicom/dicom.h"

#include <array>
#include <cstddef>

#include <vtkDICOMReader.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include "base/error.h"
#include "readers/vtk_messages.h"
#include "volume/read/input/bytes.h"

namespace isolux::readers {

namespace {

using base::throwInput;

constexpr const char* kJpegBaseline = "1.2.840.10008.1.2.4.50";

// vtk-dicom does not ask whether GDCM could decode a frame: pixels that stay as they are before were not.
class CheckedReader final : public vtkDICOMReader {
 public:
  static CheckedReader* New() { VTK_STANDARD_NEW_BODY(CheckedReader); }
  const std::string& undecoded() const { return undecoded_; }  // the first file; empty: none

 protected:
  bool ReadFileDelegated(const char* file, int index, unsigned char* pixels, vtkIdType bytes) override {
    for (vtkIdType i = 0; i < bytes; ++i) pixels[i] = mark(i);
    const bool read = vtkDICOMReader::ReadFileDelegated(file, index, pixels, bytes);
    vtkIdType same = 0;
    while (same < bytes && pixels[same] == mark(same)) ++same;
    if (undecoded_.empty() && (!read || same == bytes)) undecoded_ = file;
    return read;
  }

 private:
  static unsigned char mark(vtkIdType i) { return static_cast<unsigned char>(167 * i + (i >> 8) + 13); }
  std::string undecoded_;
};

// What a JPEG stream says of its colours, as libjpeg reads it: JFIF and Adobe's transform, else the names of
// its three components. False also where it says nothing: then the DICOM file's word counts.
bool saysYcc(const volume::FileBytes& bytes, std::uint64_t at) {
  const auto take = [&](std::size_t count) {
    std::array<unsigned char, 16> taken{};
    if (count <= taken.size() && at + count <= bytes.size())
      bytes.read(at, std::as_writable_bytes(std::span(taken).first(count)));
    return taken;
  };
  bool ycc = false;
  for (at += 2;;) {  // behind its beginning
    const auto marker = take(4);
    if (marker[0] != 0xff) return ycc;
    const std::size_t length = std::size_t{marker[2]} << 8 | marker[3];
    at += 4;
    const auto text = take(14);
    const std::string_view word(reinterpret_cast<const char*>(text.data()), 5);
    if (marker[1] == 0xee && word == "Adobe") return text[11] != 0;
    if (marker[1] == 0xe0 && word.starts_with("JFIF")) ycc = true;
    const bool frame =
        marker[1] >= 0xc0 && marker[1] <= 0xcf && marker[1] != 0xc4 && marker[1] != 0xc8 && marker[1] != 0xcc;
    if (frame) return ycc || (text[5] == 3 && text[6] == 1 && text[9] == 2 && text[12] == 3);
    if (length < 2) return ycc;
    at += length - 2;
  }
}

// Many a file says RGB of JPEG in YCbCr, which vtk-dicom turns into RGB; of those that are RGB that must not
// be done.
bool hasYcc(const DicomFile& file) {
  if (file.photometric != "RGB" || file.transferSyntax != kJpegBaseline) return true;
  const volume::FileBytes bytes(file.path);
  // Items: where the frames begin, then the frames.
  std::uint64_t at = file.pixelDataAt;
  for (int item = 0; item < 2; ++item) {
    std::array<unsigned char, 8> head{};
    if (at + head.size() > bytes.size()) return true;
    bytes.read(at, std::as_writable_bytes(std::span(head)));
    at += head.size();
    if (item == 0) at += volume::numberAt<std::uint32_t>(&head[4], false);
  }
  return saysYcc(bytes, at);
}

std::string inSyntax(const DicomFile& file) {
  return file.transferSyntax.empty() ? "" : " (transfer syntax " + file.transferSyntax + ")";
}

}  // namespace

vtkSmartPointer<vtkDataArray> decodeFiles(const std::vector<DicomFile>& files, const std::string& name,
                                          const VtkMessages& messages, base::Progress& progress) {
  vtkNew<vtkStringArray> names;
  for (const DicomFile& file : files) names->InsertNextValue(file.path.string());
  vtkNew<CheckedReader> reader;
  watch(reader, progress);
  reader->SetFileNames(names);
  reader->SetSorting(0);
  reader->SetAutoRescale(0);
  reader->SetAutoYBRToRGB(hasYcc(files.front()) ? 1 : 0);
  reader->SetMemoryRowOrderToFileNative();
  reader->Update();
  progress.throwIfStopped();
  if (!messages.errors().empty())
    throwInput(files.size() == 1 ? files[0].path.string() : name, "pixel data",
               "vtk-dicom cannot read it: " + messages.errors().front() + inSyntax(files[0]));
  if (const std::string& file = reader->undecoded(); !file.empty())
    throwInput(file, "pixel data",
               "cannot be decoded: damaged, or beyond what GDCM knows" + inSyntax(files[0]));
  vtkPointData* const data = reader->GetOutput()->GetPointData();
  vtkDataArray* const array = data ? data->GetScalars() : nullptr;
  std::size_t pixels = 0;
  for (const DicomFile& file : files) pixels += file.decodedPixels();
  if (!array || static_cast<std::size_t>(array->GetNumberOfTuples()) != pixels ||
      array->GetNumberOfComponents() != files[0].samples)
    throwInput(name, "pixel data", "could not be read whole");
  return array;
}

}  // namespace isolux::readers
