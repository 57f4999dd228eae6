#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <glm/geometric.hpp>

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMTag.h>
#include <vtkDICOMValue.h>

#include "base/error.h"
#include "readers/dicom/dicom.h"
#include "readers/dicom/elements.h"
#include "readers/dicom/frames.h"
#include "volume/read/input/text.h"

namespace isolux::readers {

namespace {

// Takes little-endian integers and texts from the front; none once the header ends.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : rest_(bytes) {}

  std::string_view take(std::int64_t count) {
    if (count < 0 || static_cast<std::uint64_t>(count) > rest_.size()) {
      ended_ = true;
      return {};
    }
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  std::int32_t integer() {
    const std::string_view bytes = take(4);
    std::int32_t value = 0;
    if (bytes.size() == 4) std::memcpy(&value, bytes.data(), 4);
    return value;
  }
  bool ended() const { return ended_; }

 private:
  std::string_view rest_;
  bool ended_ = false;
};

std::string upToZero(std::string_view text) {
  return std::string(volume::trimmed(text.substr(0, text.find('\0'))));
}

// The values of one tag of a CSA header, versions 1 and 2; none where it is missing or damaged. Layout:
// nibabel's documentation, "Siemens CSA header", and its csareader.py.
std::vector<std::string> csaValues(std::string_view header, std::string_view tag) {
  Cursor cursor(header);
  const bool second = header.starts_with("SV10");
  if (second) cursor.take(8);
  const std::int32_t tags = cursor.integer();
  cursor.integer();
  std::int32_t itemsOfFirst = 0;  // version 1 adds it to the length of each item
  for (std::int32_t t = 0; t < tags && !cursor.ended(); ++t) {
    const std::string name = upToZero(cursor.take(64));
    const std::int32_t count = cursor.integer();
    cursor.take(8);
    const std::int32_t items = cursor.integer();
    cursor.integer();
    if (t == 0) itemsOfFirst = items;
    std::vector<std::string> values;
    for (std::int32_t i = 0; i < items && !cursor.ended(); ++i) {
      const std::int32_t a = cursor.integer(), b = cursor.integer();
      cursor.take(8);
      const std::int64_t length = second ? b : std::int64_t{a} - itemsOfFirst;
      if (!second && length < 0) break;
      const std::string value = upToZero(cursor.take(length));
      cursor.take((4 - length % 4) % 4);
      if (i < count) values.push_back(value);
    }
    if (name == tag && !cursor.ended()) return values;
  }
  return {};
}

std::vector<std::string> csaValues(vtkDICOMMetaData* meta, std::string_view tag) {
  const vtkDICOMTag place = meta->ResolvePrivateTag(vtkDICOMTag(0x0029, 0x0010), "SIEMENS CSA HEADER");
  const vtkDICOMValue& value = meta->Get(place);
  const auto* bytes = reinterpret_cast<const char*>(value.GetUnsignedCharData());
  return bytes ? csaValues(std::string_view(bytes, value.GetVL()), tag) : std::vector<std::string>();
}

int slicesOf(vtkDICOMMetaData* meta) {
  const vtkDICOMTag place = meta->ResolvePrivateTag(vtkDICOMTag(0x0019, 0x000a), "SIEMENS MR HEADER");
  if (const auto stated = numberIn(meta->Get(place)))
    return static_cast<int>(std::clamp(*stated, 0.0, 65535.0));
  const std::vector<std::string> values = csaValues(meta, "NumberOfImagesInMosaic");
  const auto count = values.empty() ? std::nullopt : volume::integerOf(values[0]);
  return count && *count > 0 && *count < 65536 ? static_cast<int>(*count) : 0;
}

// The direction from slice to slice, as long as 1; nothing: not stated.
std::optional<glm::dvec3> normalOf(vtkDICOMMetaData* meta) {
  const std::vector<std::string> values = csaValues(meta, "SliceNormalVector");
  glm::dvec3 normal;
  if (values.size() < 3) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = volume::realOf(values[static_cast<std::size_t>(axis)]);
    if (!value) return std::nullopt;
    normal[axis] = *value;
  }
  if (!(std::abs(glm::length(normal) - 1.0) < 0.01)) return std::nullopt;
  return glm::normalize(normal);
}

void cutIntoTiles(glm::ivec2 tiles, int slices, const DicomFrame& tile, DicomFile& file) {
  file.tilesAcross = tiles.x;
  file.tilesDown = tiles.y;
  file.columns /= tiles.x;
  file.rows /= tiles.y;
  file.frames.assign(static_cast<std::size_t>(slices), tile);
}

}  // namespace

void splitSiemensMosaic(vtkDICOMMetaData* meta, DicomFile& file) {
  const int slices = slicesOf(meta);
  const int across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(slices))));
  if (slices < 1 || file.frames.size() != 1 || file.columns % across != 0 || file.rows % across != 0)
    base::throwInput(file.path.string(), "ImageType",
                     "is a Siemens mosaic without the number of slices; dcm2niix may convert it");
  DicomFrame tile = file.frames.front();
  const glm::dvec3 right = tile.rowDirection * tile.spacingXMm, down = tile.columnDirection * tile.spacingYMm;
  // The position is that of a slice as large as the mosaic, with the same centre.
  tile.positionMm += 0.5 * (right * static_cast<double>(file.columns - file.columns / across) +
                            down * static_cast<double>(file.rows - file.rows / across));
  const auto stated = normalOf(meta);
  const glm::dvec3 normal = stated ? *stated : glm::cross(tile.rowDirection, tile.columnDirection);
  if (!stated)
    file.warnings.emplace_back("a mosaic without SliceNormalVector: the first end of the stack is unknown");
  const double distance = tile.thicknessMm > 0.0 ? tile.thicknessMm : 1.0;
  if (!(tile.thicknessMm > 0.0)) file.warnings.emplace_back("no distance of slices is stated; 1 mm assumed");
  cutIntoTiles({across, across}, slices, tile, file);
  for (int k = 0; k < slices; ++k)
    file.frames[static_cast<std::size_t>(k)].positionMm += normal * (distance * k);
}

void splitUnitedMosaic(vtkDICOMMetaData* meta, DicomFile& file) {
  const auto element = [&](std::uint16_t number) -> const vtkDICOMValue& {
    return meta->Get(meta->ResolvePrivateTag(vtkDICOMTag(0x0065, number), "Image Private Header"));
  };
  const int slices = static_cast<int>(std::clamp(numberIn(element(0x0050)).value_or(0.0), 0.0, 65535.0));
  const int across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(slices))));
  const int down = slices > 0 ? (slices + across - 1) / across : 0;
  const vtkDICOMValue& items = element(0x0051);
  const vtkDICOMItem* const item = items.GetSequenceData();
  if (slices < 1 || file.frames.size() != 1 || file.columns % across != 0 || file.rows % down != 0 || !item ||
      items.GetNumberOfValues() != static_cast<std::size_t>(slices))
    base::throwInput(
        file.path.string(), "ImageType",
        "is a mosaic of United Imaging that does not say where its tiles lie; dcm2niix may convert it");
  cutIntoTiles({across, down}, slices, file.frames.front(), file);
  for (int k = 0; k < slices; ++k) {
    DicomFrame& frame = file.frames[static_cast<std::size_t>(k)];
    setPosition(numbersIn(item[k].Get(DC::ImagePositionPatient), 3),
                numbersIn(meta->Get(DC::ImageOrientationPatient), 6), frame);
    if (!frame.hasPosition)
      base::throwInput(file.path.string(), "ImagePositionPatient", "is missing for a tile of its mosaic");
  }
}

}  // namespace isolux::readers
