#include "volume/read/plain/nifti.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/plain/nifti_labels.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

// The fields of either version that matter here.
struct NiftiFields {
  int version = 1;
  Endianness endianness = Endianness::little;
  std::int64_t dim[8] = {};
  std::int64_t datatype = 0, bitpix = 0, intent = 0;
  double pixdim[8] = {};
  double voxOffset = 0.0;
  std::uint64_t offset = 0;
  double slope = 0.0, intercept = 0.0;
  int units = 0;
  std::int64_t qformCode = 0, sformCode = 0;
  double quaternion[3] = {}, qoffset[3] = {};
  double srow[3][4] = {};
  bool pair = false;
};

// Where the fields of a version stand, bytes.
struct NiftiPlaces {
  std::size_t dim, intent, datatype, pixdim, voxOffset, slope, units, forms, orientation;
};

template <class Size, class Code, class Real, class Offset>
NiftiFields fieldsAt(const NiftiPlaces& at, std::string_view head, bool big) {
  const auto number = [&]<class T>(T, std::size_t place) { return numberAt<T>(head.data() + place, big); };
  const auto real = [&](std::size_t place, std::size_t i) {
    return static_cast<double>(number(Real{}, place + i * sizeof(Real)));
  };
  NiftiFields f;
  for (std::size_t i = 0; i < 8; ++i) {
    f.dim[i] = number(Size{}, at.dim + i * sizeof(Size));
    f.pixdim[i] = real(at.pixdim, i);
  }
  f.intent = number(Code{}, at.intent);
  f.datatype = number(std::int16_t{}, at.datatype);
  f.bitpix = number(std::int16_t{}, at.datatype + 2);
  f.voxOffset = static_cast<double>(number(Offset{}, at.voxOffset));
  f.slope = real(at.slope, 0);
  f.intercept = real(at.slope, 1);
  f.units = static_cast<unsigned char>(head[at.units]);
  f.qformCode = number(Code{}, at.forms);
  f.sformCode = number(Code{}, at.forms + sizeof(Code));
  for (std::size_t i = 0; i < 3; ++i) {
    f.quaternion[i] = real(at.orientation, i);
    f.qoffset[i] = real(at.orientation, 3 + i);
    for (std::size_t j = 0; j < 4; ++j) f.srow[i][j] = real(at.orientation, 6 + 4 * i + j);
  }
  return f;
}

NiftiFields readVersion1(std::string_view head, bool big) {
  return fieldsAt<std::int16_t, std::int16_t, float, float>({40, 68, 70, 76, 108, 112, 123, 252, 256}, head,
                                                            big);
}

NiftiFields readVersion2(std::string_view head, bool big) {
  const std::size_t units = big ? 503 : 500;  // the lowest byte of four
  NiftiFields f = fieldsAt<std::int64_t, std::int32_t, double, std::int64_t>(
      {16, 504, 12, 104, 168, 176, units, 344, 352}, head, big);
  f.version = 2;
  return f;
}

struct Signature {
  int version = 0;  // 0: none
  bool big = false;
};

Signature signatureOf(std::string_view head) {
  if (head.size() < 348) return {};
  for (const bool big : {false, true}) {
    const auto size = numberAt<std::int32_t>(head.data(), big);
    if (size == 348) return {1, big};
    if (size == 540 && head.size() >= 540) return {2, big};
  }
  return {};
}

bool isPairMagic(std::string_view magic) {
  return magic.starts_with("ni1") || magic.starts_with("ni2");
}
bool isSingleMagic(std::string_view magic) {
  return magic.starts_with("n+1") || magic.starts_with("n+2");
}
std::string_view magicOf(std::string_view head, int version) {
  return head.substr(version == 1 ? 344 : 4, 3);
}

NiftiFields fieldsOf(std::string_view head, const std::string& file) {
  if (head.size() < 348)
    throwInput(file, "header",
               "truncated: a NIfTI header has 348 bytes, these are " + std::to_string(head.size()));
  const Signature signature = signatureOf(head);
  if (signature.version == 0) throwInput(file, "sizeof_hdr", "is neither 348 nor 540");
  const std::string_view magic = magicOf(head, signature.version);
  if (!isPairMagic(magic) && !isSingleMagic(magic))
    throwInput(file, "magic",
               "is not NIfTI's; ANALYZE 7.5 files are not read, they do not tell left from right");
  NiftiFields fields =
      signature.version == 1 ? readVersion1(head, signature.big) : readVersion2(head, signature.big);
  fields.endianness = signature.big ? Endianness::big : Endianness::little;
  fields.pair = isPairMagic(magic);
  const double least = fields.pair ? 0.0 : (fields.version == 1 ? 352.0 : 544.0);
  if (!fields.pair && fields.voxOffset == 0.0) fields.voxOffset = least;  // some writers leave it out
  if (!std::isfinite(fields.voxOffset) || fields.voxOffset < least || fields.voxOffset > 1e15 ||
      fields.voxOffset != std::trunc(fields.voxOffset))
    throwInput(file, "vox_offset", base::shortText(fields.voxOffset) + " is not a place for the voxels");
  fields.offset = static_cast<std::uint64_t>(fields.voxOffset);
  return fields;
}

void readType(const NiftiFields& fields, const std::string& file, ImageHeader& header) {
  struct Code {
    int code;
    VoxelType type;
    int components, bits;
  };
  static constexpr Code codes[] = {
      {2, VoxelType::uint8, 1, 8},        {4, VoxelType::int16, 1, 16},    {8, VoxelType::int32, 1, 32},
      {16, VoxelType::float32, 1, 32},    {32, VoxelType::float32, 2, 64}, {64, VoxelType::float64, 1, 64},
      {128, VoxelType::uint8, 3, 24},     {256, VoxelType::int8, 1, 8},    {512, VoxelType::uint16, 1, 16},
      {768, VoxelType::uint32, 1, 32},    {1024, VoxelType::int64, 1, 64}, {1280, VoxelType::uint64, 1, 64},
      {1792, VoxelType::float64, 2, 128}, {2304, VoxelType::uint8, 4, 32}};
  for (const Code& code : codes) {
    if (code.code != fields.datatype) continue;
    header.type = code.type;
    header.components = code.components;
    if (fields.bitpix != code.bits)
      header.warnings.push_back("bitpix is " + std::to_string(fields.bitpix) + ", the datatype says " +
                                std::to_string(code.bits) + "; the datatype is believed");
    return;
  }
  const char* name = fields.datatype == 1      ? " (1 bit)"
                     : fields.datatype == 1536 ? " (float128)"
                     : fields.datatype == 2048 ? " (complex256)"
                                               : "";
  throwInput(file, "datatype",
             "the voxel type " + std::to_string(fields.datatype) + name + " is not supported");
}

void readDims(const NiftiFields& fields, const std::string& file, ImageHeader& header) {
  const std::int64_t axes = fields.dim[0];
  if (axes < 1 || axes > 7)
    throwInput(file, "dim[0]", std::to_string(axes) + " axes are announced; 1 to 7 are possible");
  std::int64_t sizes[8] = {0, 1, 1, 1, 1, 1, 1, 1};
  for (std::int64_t i = 1; i <= axes; ++i) {
    sizes[i] = fields.dim[i];
    if (i > 3 && sizes[i] == 0) {  // some writers do not fill in axes that they do not have
      sizes[i] = 1;
      header.warnings.push_back("dim[" + std::to_string(i) + "] is 0; 1 assumed");
    }
    if (sizes[i] < 1)
      throwInput(file, "dim[" + std::to_string(i) + "]",
                 "is " + std::to_string(sizes[i]) + "; at least 1 is needed");
  }
  if (sizes[6] != 1 || sizes[7] != 1) throwInput(file, "dim[6]", "more than 5 axes are not supported");
  for (std::size_t i = 0; i < 3; ++i) header.dims[i] = sizes[i + 1];
  header.timeSteps = sizes[4];
  header.slowComponents = sizes[5];
  checkDims(header, file, "dim");
}

glm::dmat4 rasFromSform(const NiftiFields& f) {
  glm::dmat4 m(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) m[column][row] = f.srow[row][column];
  return m;
}

// NIfTI-1 standard, "method 2": rotation from the quaternion (a, b, c, d) with a >= 0, times the voxel sizes,
// the third negated when qfac = pixdim[0] is -1.
glm::dmat4 rasFromQform(const NiftiFields& f, const glm::dvec3& sizes) {
  double b = f.quaternion[0], c = f.quaternion[1], d = f.quaternion[2];
  double a = 1.0 - (b * b + c * c + d * d);
  if (a < 1e-7) {  // rounded to a little more than a half turn
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length;
    c /= length;
    d /= length;
    a = 0.0;
  } else {
    a = std::sqrt(a);
  }
  const double qfac = f.pixdim[0] < 0.0 ? -1.0 : 1.0;
  glm::dmat4 m(1.0);
  m[0] = glm::dvec4(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c), 0.0) * sizes.x;
  m[1] = glm::dvec4(2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b), 0.0) * sizes.y;
  m[2] = glm::dvec4(2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b, 0.0) * sizes.z *
         qfac;
  m[3] = glm::dvec4(f.qoffset[0], f.qoffset[1], f.qoffset[2], 1.0);
  return m;
}

// The codes of the standard, 1 (scanner) to 5 (another template), are all of patients, RAS+; others mean
// nothing.
scene::WorldAxes axesOfCode(int code) {
  return code >= 1 && code <= 5 ? scene::WorldAxes::anatomical : scene::WorldAxes::zUp;
}

double millimetresOf(const NiftiFields& fields, std::vector<std::string>& warnings) {
  constexpr double units[] = {1.0, 1000.0, 1.0, 0.001};  // the first: not said: mm, as all programs take it
  const int unit = fields.units & 7;
  if (unit < 4) return units[unit];
  warnings.push_back("xyzt_units names no known unit of length; mm is taken, as other programs do");
  return 1.0;
}

// Both stated, and not the same: a mirrored one makes left and right uncertain. Two of different codes may
// lead to different spaces, but not change the hand.
void compareForms(const NiftiFields& fields, const glm::dvec3& sizes, double mm, ImageHeader& header) {
  const glm::dmat4 sform = rasFromSform(fields), qform = rasFromQform(fields, sizes);
  if (!usableAffine(qform)) return;
  if (glm::determinant(glm::dmat3(sform)) * glm::determinant(glm::dmat3(qform)) < 0.0) {
    header.axes = scene::WorldAxes::zUp;
    header.warnings.push_back(
        "the sform and the qform mirror each other; the sform is used, left and right are not certain");
    return;
  }
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec4 voxel(0.0, 0.0, 0.0, 1.0);
    for (int axis = 0; axis < 3; ++axis)
      if (corner >> axis & 1)
        voxel[axis] = static_cast<double>(header.dims[static_cast<std::size_t>(axis)] - 1);
    farthest = std::max(farthest, glm::length(glm::dvec3(sform * voxel) - glm::dvec3(qform * voxel)));
  }
  const double voxel = std::max({sizes.x, sizes.y, sizes.z});
  double segment = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    segment = std::max(segment, std::abs(std::log(glm::length(glm::dvec3(sform[axis])) / sizes[axis])));
  if (fields.sformCode == fields.qformCode ? farthest > voxel : segment > 0.02)
    header.warnings.push_back(
        "the sform and the qform place voxels up to " + base::shortText(farthest * mm, 3) + " mm apart" +
        (segment > 0.02 ? ", and state different voxel sizes" : "") + "; the sform is used");
}

void readGeometry(const NiftiFields& fields, ImageHeader& header) {
  const double mm = millimetresOf(fields, header.warnings);
  glm::dvec3 sizes(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::abs(fields.pixdim[axis + 1]);
    if (std::isfinite(size) && size >= 1e-9 && size <= 1e9)
      sizes[axis] = size;
    else if (fields.sformCode <= 0)
      header.warnings.push_back("pixdim[" + std::to_string(axis + 1) + "] is " +
                                base::shortText(fields.pixdim[axis + 1]) + "; " +
                                std::string(kSpacingAssumed));
  }
  // x and y change sign from RAS to LPS; the fourth row stays.
  const auto lps = [mm](const glm::dmat4& ras) {
    glm::dmat4 m = ras;
    for (int column = 0; column < 4; ++column) m[column] *= glm::dvec4(-mm, -mm, mm, 1.0);
    return m;
  };
  if (fields.sformCode > 0) {
    header.worldFromVoxel = lps(rasFromSform(fields));
    header.axes = axesOfCode(fields.sformCode);
    if (usableAffine(header.worldFromVoxel)) {
      if (fields.qformCode > 0) compareForms(fields, sizes, mm, header);
      return;
    }
    header.warnings.push_back("the sform is singular or not finite; ignored");
  }
  if (fields.qformCode > 0) {
    header.worldFromVoxel = lps(rasFromQform(fields, sizes));
    header.axes = axesOfCode(fields.qformCode);
    if (usableAffine(header.worldFromVoxel)) return;
    header.warnings.push_back("the qform is not finite; ignored");
  }
  header.warnings.push_back("no usable orientation (sform, qform); left and right are not certain");
  glm::dmat4 plain(1.0);
  for (int axis = 0; axis < 3; ++axis) plain[axis][axis] = sizes[axis];
  header.worldFromVoxel = lps(plain);
  header.axes = scene::WorldAxes::zUp;
}

// The codes of nifti1.h that say what kind of object the numbers are.
void readIntent(const NiftiFields& fields, const std::string& file, ImageHeader& header) {
  const std::int64_t intent = fields.intent;
  if (intent == 1002 || intent == 1003)
    header.labels = std::make_shared<const LabelTable>(
        LabelTable{"its intent_code is " + std::to_string(intent) + ", labels", "", {}});
  if (intent == 1008 || intent == 1009 || intent == 2002 || (intent >= 3000 && intent < 3100))
    throwInput(file, "intent_code",
               intent >= 3000 ? "CIFTI files, whose numbers belong to surfaces, are not read"
                              : std::to_string(intent) + ": points or triangles are not voxels");
}

}  // namespace

fs::path counterpart(const fs::path& path, std::string_view wanted) {
  fs::path stem = path;
  if (sameIgnoringCase(stem.extension().string(), ".gz")) stem.replace_extension();
  for (const char* ending : {"", ".gz"}) {
    fs::path candidate = stem;
    candidate.replace_extension(std::string(wanted) + ending);
    std::error_code ignored;
    if (fs::exists(candidate, ignored)) return candidate;
  }
  return {};
}

bool looksLikeNifti(std::string_view head) {
  const Signature signature = signatureOf(head);
  if (signature.version == 0) return false;
  const std::string_view magic = magicOf(head, signature.version);
  return isPairMagic(magic) || isSingleMagic(magic);
}

ImageHeader parseNiftiHeader(std::string_view head, const std::string& file, bool& pairs) {
  const NiftiFields fields = fieldsOf(head, file);
  ImageHeader header;
  header.format = fields.version == 1 ? "NIfTI-1" : "NIfTI-2";
  readIntent(fields, file, header);
  readType(fields, file, header);
  readDims(fields, file, header);
  readGeometry(fields, header);
  header.slope = fields.slope;  // 0 and not finite: none, see ImageHeader
  header.intercept = fields.intercept;
  if (fields.datatype == 128 || fields.datatype == 2304) {  // by definition not applied to colours
    header.slope = 0.0;
  } else if (std::isfinite(fields.slope) && fields.slope != 0.0 && !std::isfinite(fields.intercept)) {
    header.intercept = 0.0;
    header.warnings.push_back("scl_inter is not finite; 0 assumed");
  }
  header.payload.endianness = fields.endianness;
  header.payload.offset = fields.offset;
  pairs = fields.pair;
  return header;
}

namespace {

constexpr std::size_t kMostExtensionBytes = std::size_t{4} << 20;

// Labels that an extension between header and voxels names.
void readExtensions(const Bytes& bytes, bool compressed, std::string_view head, ImageHeader& header) {
  const Signature signature = signatureOf(head);
  const std::size_t begin = signature.version == 1 ? 348 : 540;
  const std::uint64_t end = header.payload.offset;
  if (end < begin + 12 || end - begin > kMostExtensionBytes) return;
  const auto count = static_cast<std::size_t>(end);
  const std::string whole = compressed ? inflatedHead(bytes, count) : bytes.head(count);
  if (whole.size() < count) return;
  if (auto table = labelsInExtensions(std::string_view(whole).substr(begin), signature.big))
    header.labels = std::make_shared<const LabelTable>(std::move(*table));
}

}  // namespace

NiftiFiles openNifti(const fs::path& path) {
  NiftiFiles files{.header = {}, .headerPath = path, .dataPath = path};
  const std::string extension =
      lowered((path.extension() == ".gz" ? path.stem() : path).extension().string());
  if (extension == ".img") {
    files.headerPath = counterpart(path, ".hdr");
    if (files.headerPath.empty())
      throwInput(path.string(), "", "the header (.hdr) of this .img file is missing");
  }
  const FileBytes headerBytes(files.headerPath);
  if (headerBytes.size() == 0) throwInput(headerBytes.name(), "", "the file is empty");
  const bool compressedHeader = isPacked(headerBytes.head(4));
  const std::string head =
      compressedHeader ? inflatedHead(headerBytes, niftiHeaderBytes) : headerBytes.head(niftiHeaderBytes);
  if (compressedHeader && head.empty())
    throwInput(headerBytes.name(), "byte 0", "the compressed data are damaged");
  bool pairs = false;
  files.header = parseNiftiHeader(head, headerBytes.name(), pairs);
  files.dataPath = files.headerPath;
  const bool headerAlone = head.size() <= 352 && (extension == ".hdr" || extension == ".img");
  if (!pairs && headerAlone && !counterpart(files.headerPath, ".img").empty()) {
    pairs = true;
    files.header.payload.offset = 0;
    files.header.warnings.push_back(
        "the header says that the voxels follow it; those of the .img file are read");
  }
  if (!pairs) readExtensions(headerBytes, compressedHeader, head, files.header);
  if (pairs) {
    files.dataPath = extension == ".img" ? path : counterpart(files.headerPath, ".img");
    if (files.dataPath.empty())
      throwInput(headerBytes.name(), "data file", "the .img file of this header is missing");
  }
  Payload& payload = files.header.payload;
  if (pairs ? isPacked(FileBytes(files.dataPath).head(4)) : compressedHeader) {
    payload.encoding = Encoding::zlib;
    payload.skipDecoded = payload.offset;
    payload.offset = 0;
  }
  return files;
}

}  // namespace isolux::volume
