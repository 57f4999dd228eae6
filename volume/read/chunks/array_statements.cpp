#include "volume/read/chunks/array_statements.h"

#include <algorithm>
#include <set>

#include "base/number_text.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/length_unit.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace {

// Degrees of latitude and longitude are one unit.
std::string kindOfUnit(const std::string& unit) {
  if (millimetresIn(unit)) return "length";
  return lowered(unit).starts_with("degree") ? "degrees" : lowered(unit);
}

// mm in a unit of the stated axes; nothing where the units of axes cannot be compared.
std::optional<double> commonUnit(const std::vector<const AxisStatement*>& stated,
                                 std::vector<std::string>& warnings) {
  std::set<std::string> kinds;
  for (const AxisStatement* axis : stated) kinds.insert(kindOfUnit(axis->unit));
  if (kinds.size() > 1) {
    std::string units;
    for (const AxisStatement* axis : stated)
      units += (units.empty() ? "" : ", ") + (axis->unit.empty() ? "none" : inQuotes(axis->unit));
    warnings.push_back("the axes have units that cannot be compared (" + units + "): voxels of " +
                       std::string(kSpacingAssumed));
    return std::nullopt;
  }
  return millimetresOr1(stated.front()->unit, "", warnings);
}

void noteUneven(const AxisStatement& axis, char letter, std::vector<std::string>& warnings) {
  constexpr double even = 0.01;  // of a step
  if (!(axis.deviation > even)) return;
  warnings.push_back("positions along " + std::string(1, letter) + " are " + std::string(kUnevenSpacing) +
                     " (up to " + base::shortText(axis.deviation, 3) + " steps off); their mean step of " +
                     base::shortText(std::abs(*axis.step)) + (axis.unit.empty() ? "" : " " + axis.unit) +
                     " is taken");
}

class StatedNumbers final : public ChunkedArray {
 public:
  StatedNumbers(std::shared_ptr<const ChunkedArray> array, const ArrayStatements& statements)
      : array_(std::move(array)),
        layout_(array_->layout()),
        missing_(statements.missing),
        slices_(statements.slices) {
    const bool narrow = bytesOf(layout_.type) <= 2 || layout_.type == VoxelType::float32;
    layout_.type = narrow && slices_.slopes.empty() ? VoxelType::float32 : VoxelType::float64;
  }

  const ArrayLayout& layout() const override { return layout_; }
  bool plain() const override { return array_->plain(); }
  VoxelType fileType() const override { return array_->fileType(); }
  ArrayChunk read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                  std::span<const std::uint64_t> size) const override {
    const ArrayChunk stored = array_->read(index, low, size);
    ArrayChunk values{{},
                      {low.begin(), low.end()},
                      std::vector<std::uint64_t>(size.size()),
                      stored.bytesRead,
                      stored.missing};
    std::uint64_t count = 1;
    for (std::size_t axis = size.size(); axis-- > 0;) {
      values.strides[axis] = count;
      count *= size[axis];
    }
    values.bytes.resize(static_cast<std::size_t>(count) * bytesOf(layout_.type));
    withType(array_->layout().type, [&]<class From>(From) {
      const Box<From> box{index, low, size, stored, reinterpret_cast<const From*>(stored.bytes.data()),
                          count};
      if (layout_.type == VoxelType::float32)
        convert(box, reinterpret_cast<float*>(values.bytes.data()));
      else
        convert(box, reinterpret_cast<double*>(values.bytes.data()));
    });
    return values;
  }

 private:
  template <class From>
  struct Box {
    std::span<const std::uint64_t> index, low, size;
    const ArrayChunk& stored;
    const From* numbers;
    std::uint64_t count;
  };

  bool isMissing(double number) const {
    if (!(number >= missing_.least && number <= missing_.greatest)) return true;
    return std::ranges::find(missing_.values, number) != missing_.values.end();
  }

  // Of the row that begins at `at`, a place in the chunk.
  std::size_t sliceOf(std::span<const std::uint64_t> index, const std::vector<std::uint64_t>& at) const {
    std::uint64_t slice = 0;
    for (std::size_t axis = 0; axis < slices_.axes; ++axis)
      slice = slice * layout_.dims[axis] + index[axis] * layout_.chunk[axis] + at[axis];
    return static_cast<std::size_t>(slice);
  }

  template <class From, class To>
  void convert(const Box<From>& box, To* out) const {
    const std::size_t last = box.size.size() - 1;
    std::vector<std::uint64_t> at(box.low.begin(), box.low.end());
    for (std::uint64_t done = 0; done < box.count; done += box.size[last]) {
      std::uint64_t place = 0;
      for (std::size_t axis = 0; axis <= last; ++axis)
        place += (at[axis] - box.stored.start[axis]) * box.stored.strides[axis];
      for (std::uint64_t x = 0; x < box.size[last]; ++x) {
        const auto number = static_cast<double>(box.numbers[place + x * box.stored.strides[last]]);
        double value = number;
        if (!slices_.slopes.empty()) {
          if (slices_.axes > last) at[last] = box.low[last] + x;
          const std::size_t slice = sliceOf(box.index, at);
          value = slices_.slopes[slice] * number + slices_.intercepts[slice];
        }
        *out++ = isMissing(number) ? std::numeric_limits<To>::quiet_NaN() : static_cast<To>(value);
      }
      at[last] = box.low[last];
      for (std::size_t axis = last; axis-- > 0;) {
        if (++at[axis] < box.low[axis] + box.size[axis]) break;
        at[axis] = box.low[axis];
      }
    }
  }

  std::shared_ptr<const ChunkedArray> array_;
  ArrayLayout layout_;
  MissingNumbers missing_;
  SliceScaling slices_;
};

}  // namespace

void setPositions(AxisStatement& axis, std::span<const double> positions) {
  const bool usable =
      positions.size() >= 2 && std::ranges::all_of(positions, [](double p) { return std::isfinite(p); });
  if (!usable) return;
  axis.first = positions.front();
  axis.step = (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
  if (*axis.step == 0.0) return;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double even = axis.first + static_cast<double>(i) * *axis.step;
    axis.deviation = std::max(axis.deviation, std::abs((positions[i] - even) / *axis.step));
  }
}

std::vector<std::string> namesOf(const std::vector<AxisStatement>& axes) {
  std::vector<std::string> names;
  for (const AxisStatement& axis : axes) names.push_back(axis.name);
  return names;
}

void applyStatements(const ArrayStatements& statements, const ArrayAxes& axes,
                     const std::vector<std::uint64_t>& dims, ChunkedFacts& facts) {
  const std::optional<std::size_t> space[] = {axes.x, axes.y, axes.z};
  glm::dmat3 directions(1.0);
  glm::dvec3 spacing(1.0), origin = statements.originMm;
  std::vector<const AxisStatement*> stated;
  bool silent = false;
  for (const auto& axis : space) {
    if (!axis) continue;
    const AxisStatement* const said = statements.axes.empty() ? nullptr : &statements.axes[*axis];
    if (said && said->step)
      stated.push_back(said);
    else
      silent = silent || dims[*axis] > 1;
  }
  facts.warnings.insert(facts.warnings.end(), statements.warnings.begin(), statements.warnings.end());
  if (silent)
    facts.warnings.push_back("the array does not state the voxel size; " + std::string(kSpacingAssumed));
  const auto unit = stated.empty() ? std::nullopt : commonUnit(stated, facts.warnings);
  for (int d = 0; d < 3 && !statements.axes.empty(); ++d) {
    if (!space[d]) continue;
    const AxisStatement& axis = statements.axes[*space[d]];
    if (axis.direction != glm::dvec3(0.0)) directions[d] = axis.direction;
    if (!axis.step) continue;
    if (unit) {
      noteUneven(axis, "xyz"[d], facts.warnings);
      const double mm = millimetresIn(axis.unit).value_or(*unit);
      spacing[d] = std::abs(*axis.step) * mm;
      origin += axis.first * mm * directions[d];
    }
    if (*axis.step < 0.0) directions[d] = -directions[d];
  }
  facts.levels.front().geometry.worldFromVoxel =
      checkedGeometry(directions, spacing, origin, facts.name, facts.warnings);
  if (statements.anatomical) facts.axes = scene::WorldAxes::anatomical;
  facts.unit = statements.unit;
  facts.slope = statements.slope;
  facts.intercept = statements.intercept;
}

std::shared_ptr<const ChunkedArray> valuesOf(std::shared_ptr<const ChunkedArray> array,
                                             const ArrayStatements& statements) {
  if (!statements.missing.any() && statements.slices.slopes.empty()) return array;
  return std::make_shared<const StatedNumbers>(std::move(array), statements);
}

}  // namespace isolux::volume
