// DICOM files, written element by element (explicit VR, little endian).
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/volume/read/reader_support.h"

namespace isolux::test {

// One element with a short or long length field, padded to an even size.
inline std::string element(std::uint16_t group, std::uint16_t number, const std::string& vr,
                           std::string value) {
  if (value.size() % 2) value += vr == "UI" || vr == "OW" || vr == "OB" ? '\0' : ' ';
  std::string out = bytesOf<std::uint16_t>({group, number}) + vr;
  if (vr == "OW" || vr == "OB" || vr == "SQ" || vr == "UN")
    out += std::string(2, '\0') + bytesOf<std::uint32_t>({static_cast<std::uint32_t>(value.size())});
  else
    out += bytesOf<std::uint16_t>({static_cast<std::uint16_t>(value.size())});
  return out + value;
}

inline std::string us(int value) {
  return bytesOf<std::uint16_t>({static_cast<std::uint16_t>(value)});
}

inline std::string sequence(std::uint16_t group, std::uint16_t number,
                            const std::vector<std::string>& items) {
  std::string value;
  for (const std::string& item : items)
    value += bytesOf<std::uint16_t>({0xfffe, 0xe000}) +
             bytesOf<std::uint32_t>({static_cast<std::uint32_t>(item.size())}) + item;
  return element(group, number, "SQ", value);
}

struct DicomSlice {
  std::string series = "1.2.3.4", description = "head", modality = "CT";
  int instance = 1, columns = 3, rows = 2, bits = 16, samples = 1, frames = 1;
  std::string position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0", spacing = "0.75\\0.5", thickness = "2";
  std::string slope = "1", intercept = "-1024";
  std::string syntax = "1.2.840.10008.1.2.1", sopClass = "1.2.840.10008.5.1.4.1.1.2";
  std::string pixels;
  // Left out where empty.
  std::string patient, id, birthDate, study = "1.2.3", studyDescription, date, kernel, number;
  std::vector<std::string> more;  // elements besides, or in place of, those above
  std::string preamble = std::string(128, '\0');
};

// The elements of `s` in the order of their tags, without preamble and meta header.
inline std::string dicomElements(const DicomSlice& s) {
  std::map<std::uint32_t, std::string> elements;
  const auto add = [&](const std::string& bytes) {
    std::uint16_t tag[2];
    std::memcpy(tag, bytes.data(), sizeof(tag));
    elements[std::uint32_t{tag[0]} << 16 | tag[1]] = bytes;
  };
  const auto put = [&](std::uint16_t group, std::uint16_t number, const char* vr, const std::string& value) {
    if (!value.empty()) add(element(group, number, vr, value));
  };
  put(8, 0x16, "UI", s.sopClass);
  put(8, 0x18, "UI", "1.2.3.4.5." + std::to_string(s.instance));
  put(8, 0x20, "DA", s.date);
  put(8, 0x21, "DA", s.date);
  put(8, 0x60, "CS", s.modality);
  put(8, 0x1030, "LO", s.studyDescription);
  put(8, 0x103e, "LO", s.description);
  put(0x10, 0x10, "PN", s.patient);
  put(0x10, 0x20, "LO", s.id);
  put(0x10, 0x30, "DA", s.birthDate);
  put(0x18, 0x50, "DS", s.thickness);
  put(0x18, 0x1210, "SH", s.kernel);
  put(0x20, 0xd, "UI", s.study);
  put(0x20, 0xe, "UI", s.series);
  put(0x20, 0x11, "IS", s.number);
  put(0x20, 0x13, "IS", std::to_string(s.instance));
  if (!s.position.empty()) {
    put(0x20, 0x32, "DS", s.position);
    put(0x20, 0x37, "DS", s.orientation);
  }
  put(0x28, 2, "US", us(s.samples));
  put(0x28, 4, "CS", s.samples == 3 ? "RGB" : "MONOCHROME2");
  if (s.samples == 3) put(0x28, 6, "US", us(0));
  if (s.frames > 1) put(0x28, 8, "IS", std::to_string(s.frames));
  put(0x28, 0x10, "US", us(s.rows));
  put(0x28, 0x11, "US", us(s.columns));
  put(0x28, 0x30, "DS", s.spacing);
  put(0x28, 0x100, "US", us(s.bits));
  put(0x28, 0x101, "US", us(s.bits));
  put(0x28, 0x102, "US", us(s.bits - 1));
  put(0x28, 0x103, "US", us(s.bits == 16 ? 1 : 0));
  if (!s.slope.empty()) {
    put(0x28, 0x1052, "DS", s.intercept);
    put(0x28, 0x1053, "DS", s.slope);
  }
  put(0x7fe0, 0x10, s.bits > 8 ? "OW" : "OB", s.pixels);
  for (const std::string& bytes : s.more) add(bytes);
  std::string all;
  for (const auto& [tag, bytes] : elements) all += bytes;
  return all;
}

inline std::string dicom(const DicomSlice& s) {
  std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", s.sopClass) +
                     element(2, 3, "UI", "1.2.3.4.5." + std::to_string(s.instance)) +
                     element(2, 0x10, "UI", s.syntax);
  meta = element(2, 0, "UL", bytesOf<std::uint32_t>({static_cast<std::uint32_t>(meta.size())})) + meta;
  return s.preamble + "DICM" + meta + dicomElements(s);
}

// A folder with a file IM0, IM1, ... for each.
inline std::filesystem::path writeSeries(const std::vector<DicomSlice>& slices) {
  const std::filesystem::path folder = temporaryFolder() / "series";
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < slices.size(); ++i)
    writeFile(folder / ("IM" + std::to_string(i)), dicom(slices[i]));
  return folder;
}

}  // namespace isolux::test
