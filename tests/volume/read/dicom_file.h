// DICOM files, written element by element (explicit VR, little endian).
#pragma once

#include <cstdint>
#include <string>

#include "tests/volume/read/reader_support.h"

namespace isolux::test {

// One element with a short or long length field, padded to an even size.
inline std::string element(std::uint16_t group, std::uint16_t number, const std::string& vr,
                           std::string value) {
  if (value.size() % 2) value += vr == "UI" || vr == "OW" || vr == "OB" ? '\0' : ' ';
  std::string out = bytesOf<std::uint16_t>({group, number}) + vr;
  if (vr == "OW" || vr == "OB" || vr == "SQ")
    out += std::string(2, '\0') + bytesOf<std::uint32_t>({static_cast<std::uint32_t>(value.size())});
  else
    out += bytesOf<std::uint16_t>({static_cast<std::uint16_t>(value.size())});
  return out + value;
}

inline std::string us(int value) {
  return bytesOf<std::uint16_t>({static_cast<std::uint16_t>(value)});
}

struct DicomSlice {
  std::string series = "1.2.3.4", description = "head", modality = "CT";
  int instance = 1, columns = 3, rows = 2, bits = 16, samples = 1, frames = 1;
  std::string position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0", spacing = "0.75\\0.5", thickness = "2";
  std::string slope = "1", intercept = "-1024";
  std::string syntax = "1.2.840.10008.1.2.1";
  std::string pixels;
  // Left out where empty.
  std::string patient, id, birthDate, study = "1.2.3", studyDescription, date, kernel, number;
};

inline std::string dicom(const DicomSlice& s) {
  const std::string uid = "1.2.3.4.5." + std::to_string(s.instance);
  std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) +
                     element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(2, 3, "UI", uid) +
                     element(2, 0x10, "UI", s.syntax);
  meta = element(2, 0, "UL", bytesOf<std::uint32_t>({static_cast<std::uint32_t>(meta.size())})) + meta;
  const auto known = [](std::uint16_t group, std::uint16_t number, const char* vr, const std::string& value) {
    return value.empty() ? std::string() : element(group, number, vr, value);
  };
  std::string data = element(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(8, 0x18, "UI", uid) +
                     known(8, 0x20, "DA", s.date) + known(8, 0x21, "DA", s.date) +
                     element(8, 0x60, "CS", s.modality) + known(8, 0x1030, "LO", s.studyDescription) +
                     element(8, 0x103e, "LO", s.description) + known(0x10, 0x10, "PN", s.patient) +
                     known(0x10, 0x20, "LO", s.id) + known(0x10, 0x30, "DA", s.birthDate) +
                     element(0x18, 0x50, "DS", s.thickness) + known(0x18, 0x1210, "SH", s.kernel) +
                     element(0x20, 0xd, "UI", s.study) + element(0x20, 0xe, "UI", s.series) +
                     known(0x20, 0x11, "IS", s.number) +
                     element(0x20, 0x13, "IS", std::to_string(s.instance));
  if (!s.position.empty())
    data += element(0x20, 0x32, "DS", s.position) + element(0x20, 0x37, "DS", s.orientation);
  data +=
      element(0x28, 2, "US", us(s.samples)) + element(0x28, 4, "CS", s.samples == 3 ? "RGB" : "MONOCHROME2");
  if (s.samples == 3) data += element(0x28, 6, "US", us(0));
  if (s.frames > 1) data += element(0x28, 8, "IS", std::to_string(s.frames));
  data += element(0x28, 0x10, "US", us(s.rows)) + element(0x28, 0x11, "US", us(s.columns));
  if (!s.spacing.empty()) data += element(0x28, 0x30, "DS", s.spacing);
  data += element(0x28, 0x100, "US", us(s.bits)) + element(0x28, 0x101, "US", us(s.bits)) +
          element(0x28, 0x102, "US", us(s.bits - 1)) + element(0x28, 0x103, "US", us(s.bits == 16 ? 1 : 0));
  if (!s.slope.empty())
    data += element(0x28, 0x1052, "DS", s.intercept) + element(0x28, 0x1053, "DS", s.slope);
  return std::string(128, '\0') + "DICM" + meta + data +
         element(0x7fe0, 0x10, s.bits > 8 ? "OW" : "OB", s.pixels);
}

}  // namespace isolux::test
