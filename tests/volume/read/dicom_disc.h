// A disc with two patients, three studies, six series, a damaged image and things that are no images.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "tests/volume/read/dicom_file.h"

namespace isolux::test {

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

// A ball of tissue (1000) in air (0), `size` pixels a side.
inline std::string ballSlice(int size, double part) {
  std::vector<std::int16_t> pixels;
  const double centre = 0.5 * (size - 1), radius = 0.4 * size;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double r = std::hypot(std::hypot(x - centre, y - centre), (part - 0.5) * size);
      pixels.push_back(static_cast<std::int16_t>(std::lround(500.0 - 100.0 * (r - radius))));
    }
  return bytesOf(pixels);
}

// Slices of a series: `place(i)` says where slice i lies.
inline void writeDicomSeries(const std::filesystem::path& folder, DicomSlice slice, int count,
                             const std::function<std::string(int)>& place, int size = 16) {
  slice.columns = slice.rows = size;
  for (int i = 0; i < count; ++i) {
    slice.instance = i + 1;
    slice.position = place(i);
    slice.pixels = ballSlice(slice.columns, (i + 0.5) / count);
    writeBytes(folder / ("IM" + std::to_string(i)), dicom(slice));
  }
}

inline std::string placeAt(double y, double z) {
  return "0\\" + std::to_string(y) + "\\" + std::to_string(z);
}

// DICOM/PA0 is DOE^JANE: study "Head CT" with the series 1.1 (even), 1.2 (gantry tilt of 26.57 degrees), 1.3
// (a slice is missing), study "Head MR" with 1.4. DICOM/PA1 is MUSTER^MAX: 2.1 with one slice of another
// orientation and one that is cut off, 2.2 (a single slice).
inline void writeDicomDisc(const std::filesystem::path& disc, int size = 16) {
  namespace fs = std::filesystem;
  writeBytes(disc / "DICOMDIR", std::string(128, '\0') + "DICM" + std::string(64, 'x'));
  writeBytes(disc / "README.TXT", "no image");
  DicomSlice jane;
  jane.patient = "DOE^JANE";
  jane.id = "ID4711";
  jane.birthDate = "19600102";
  jane.study = "1";
  jane.studyDescription = "Head CT";
  jane.date = "20240131";
  jane.spacing = "2\\2";
  const fs::path pa0 = disc / "DICOM" / "PA0", pa1 = disc / "DICOM" / "PA1";
  const auto series = [](DicomSlice slice, const char* uid, const char* description, const char* number) {
    slice.series = uid;
    slice.description = description;
    slice.number = number;
    return slice;
  };
  DicomSlice even = series(jane, "1.1", "axial bone", "1");
  even.kernel = "H60s";
  writeDicomSeries(
      pa0 / "ST0" / "SE0", even, size, [](int i) { return placeAt(0, 2.0 * i); }, size);
  writeDicomSeries(pa0 / "ST0" / "SE1", series(jane, "1.2", "tilted", "2"), 6,
                   [](int i) { return placeAt(i, 2.0 * i); });
  writeDicomSeries(pa0 / "ST0" / "SE2", series(jane, "1.3", "with a gap", "3"), 6,
                   [](int i) { return placeAt(0, i < 3 ? 2.0 * i : 2.0 * i + 2.0); });
  DicomSlice mr = series(jane, "1.4", "T1 of DOE", "4");
  mr.study = "2";
  mr.studyDescription = "Head MR";
  mr.date = "20230630";
  mr.modality = "MR";
  writeDicomSeries(pa0 / "ST1" / "SE0", mr, 5, [](int i) { return placeAt(0, 3.0 * i); });
  DicomSlice max = jane;
  max.patient = "MUSTER^MAX";
  max.id = "0815";
  max.birthDate = "19701224";
  max.study = "3";
  max.studyDescription = "Spine";
  writeDicomSeries(pa1 / "ST0" / "SE0", series(max, "2.1", "mixed", "1"), 4,
                   [](int i) { return placeAt(0, 2.0 * i); });
  DicomSlice other = series(max, "2.1", "mixed", "1");
  other.orientation = "0\\1\\0\\0\\0\\-1";
  other.columns = other.rows = 16;
  other.position = "0\\0\\20";
  other.instance = 9;
  other.pixels = ballSlice(16, 0.5);
  writeBytes(pa1 / "ST0" / "SE0" / "IM8", dicom(other));
  const std::string whole = dicom(other);
  writeBytes(pa1 / "ST0" / "SE0" / "IM9", whole.substr(0, whole.size() - 200));
  writeDicomSeries(pa1 / "ST0" / "SE1", series(max, "2.2", "scout", "2"), 1,
                   [](int) { return placeAt(0, 0); });
}

}  // namespace isolux::test
