#include "volume/read/dicom/repeated_slices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "volume/read/input/text.h"

namespace isolux::volume {

namespace {

using Positions = std::vector<std::vector<std::size_t>>;

// Numbers by value and before all other texts.
bool comesBefore(const std::string& a, const std::string& b) {
  const auto x = realOf(a), y = realOf(b);
  const bool aIsNumber = x && std::isfinite(*x), bIsNumber = y && std::isfinite(*y);
  if (aIsNumber && bIsNumber) return *x < *y;
  return aIsNumber != bIsNumber ? aIsNumber : a < b;
}

// The tags of a slice that separate it from others at its position.
class TagOrder {
 public:
  TagOrder(const Positions& positions, const std::vector<ImageTags>& tags) : tags_(tags) {
    if (tags.empty()) return;
    for (std::size_t tag = 0; tag < kImageTags.size(); ++tag)
      if (std::ranges::any_of(positions, [&](const auto& slices) {
            return std::ranges::any_of(
                slices, [&](std::size_t slice) { return tags[slice][tag] != tags[slices.front()][tag]; });
          }))
        varying_.push_back(tag);
  }

  const std::vector<std::size_t>& varying() const { return varying_; }
  bool varies(std::size_t tag) const { return std::ranges::find(varying_, tag) != varying_.end(); }
  bool operator()(std::size_t a, std::size_t b) const { return precedes(a, b, kImageTags.size()); }

  // By the tags before `end` only.
  bool precedes(std::size_t a, std::size_t b, std::size_t end) const {
    for (const std::size_t tag : varying_) {
      if (tag >= end) break;
      if (comesBefore(tags_[a][tag], tags_[b][tag])) return true;
      if (comesBefore(tags_[b][tag], tags_[a][tag])) return false;
    }
    return false;
  }

 private:
  const std::vector<ImageTags>& tags_;
  std::vector<std::size_t> varying_;
};

std::string nameOf(std::size_t tag) {
  return std::string(kImageTags[tag]);
}

// "image type: M, P", from the slices at one position.
std::string valuesText(std::size_t tag, const std::vector<std::size_t>& slices,
                       const std::vector<ImageTags>& tags) {
  constexpr std::size_t most = 6;
  std::set<std::string, decltype(&comesBefore)> values(&comesBefore);
  for (const std::size_t slice : slices) values.insert(tags[slice][tag]);
  std::string text = nameOf(tag) + ": ";
  std::size_t count = 0;
  for (const std::string& value : values) {
    if (count == most) return text + ", ...";
    text += (count++ == 0 ? "" : ", ") + (value.empty() ? std::string("not stated") : value);
  }
  return text;
}

// What the steps are, where they are no moments of time.
void nameSteps(const TagOrder& order, const std::vector<std::size_t>& slices,
               const std::vector<ImageTags>& tags, TimeSteps& steps) {
  for (const std::size_t tag : {kImageType, kBValue, kEcho})
    if (order.varies(tag))
      steps.warnings.push_back("the time steps differ in " + valuesText(tag, slices, tags));
  if (!order.varying().empty() && order.varying().front() == kAcquisition)
    steps.warnings.push_back("the time steps differ in " + valuesText(kAcquisition, slices, tags));
}

// Whether the slices of each step are of one kind, by the tags that tell steps apart and those that tell
// kinds.
void checkKinds(const TagOrder& order, const std::vector<ImageTags>& tags, TimeSteps& steps) {
  const std::size_t positions = steps.order.size() / steps.count;
  for (std::size_t tag = kImageType; tag < kAcquisition && !tags.empty(); ++tag) {
    if (!order.varies(tag) && tag > kBValue) continue;
    for (std::size_t i = 0; i < steps.order.size(); ++i)
      if (tags[steps.order[i]][tag] != tags[steps.order[i - i % positions]][tag]) {
        steps.warnings.push_back("slices of one time step differ in " + nameOf(tag));
        break;
      }
  }
}

// Whether instance numbers order the repeated slices alike at all positions.
void checkInstances(const TagOrder& order, const Positions& given, const Positions& sorted,
                    TimeSteps& steps) {
  const auto rankOf = [&](std::size_t position, std::size_t step) {
    const auto& slices = given[position];
    return std::ranges::find(slices, sorted[position][step]) - slices.begin();
  };
  for (std::size_t position = 0; position < sorted.size(); ++position)
    for (std::size_t step = 0; step < steps.count; ++step)
      if (rankOf(position, step) != rankOf(0, step)) {
        const std::string name = nameOf(order.varying().front());
        steps.warnings.push_back("instance numbers and " + name + " order repeated slices differently; the " +
                                 name + " is used");
        return;
      }
}

TimeSteps evenSteps(const TagOrder& order, const Positions& given, const Positions& sorted,
                    const std::vector<ImageTags>& tags) {
  TimeSteps steps;
  steps.count = sorted.front().size();
  for (std::size_t step = 0; step < steps.count; ++step)
    for (const auto& slices : sorted) steps.order.push_back(slices[step]);
  steps.stated = std::ranges::all_of(sorted, [&](const auto& slices) {
    return std::ranges::adjacent_find(slices, [&](std::size_t a, std::size_t b) { return !order(a, b); }) ==
           slices.end();
  });
  if (!steps.stated)
    steps.warnings.push_back(
        "only instance numbers tell repeated slices apart: the meaning of the time steps is "
        "not stated");
  nameSteps(order, sorted.front(), tags, steps);
  if (!order.varying().empty()) checkInstances(order, given, sorted, steps);
  return steps;
}

// Positions with different numbers of slices: the steps that have one at each.
TimeSteps completeSteps(const TagOrder& order, const Positions& sorted, const std::vector<ImageTags>& tags) {
  TimeSteps steps;
  std::size_t all = 0;
  for (const auto& slices : sorted) all += slices.size();
  const auto precedes = [&](std::size_t a, std::size_t b) { return order.precedes(a, b, kTrigger); };
  std::map<std::size_t, std::vector<std::size_t>, decltype(precedes)> found(precedes);
  for (const auto& slices : sorted)
    for (const std::size_t slice : slices) found[slice].push_back(slice);
  std::vector<std::size_t> chosen;
  for (const auto& [first, slices] : found) {
    const bool whole =
        slices.size() == sorted.size() &&
        std::equal(slices.begin(), slices.end(), sorted.begin(), [](std::size_t slice, const auto& at) {
          return std::ranges::find(at, slice) != at.end();
        });
    if (!whole) continue;
    chosen.push_back(first);
    steps.order.insert(steps.order.end(), slices.begin(), slices.end());
  }
  if (!chosen.empty()) {
    steps.count = chosen.size();
    steps.warnings.push_back(std::to_string(all - steps.order.size()) +
                             " slices belong to no complete time step (" + nameOf(order.varying().front()) +
                             ") and are left out");
    if (steps.count > 1) nameSteps(order, chosen, tags, steps);
    return steps;
  }
  for (const auto& slices : sorted) steps.order.push_back(slices.front());
  steps.warnings.push_back(
      std::to_string(all - sorted.size()) +
      " slices repeat the position of another; the first of each is used" +
      (order.varying().empty() ? "" : "; they differ in " + nameOf(order.varying().front())));
  return steps;
}

}  // namespace

TimeSteps separateRepeats(const Positions& positions, const std::vector<ImageTags>& tags) {
  const TagOrder order(positions, tags);
  Positions sorted = positions;
  for (auto& slices : sorted) std::ranges::stable_sort(slices, order);
  const bool even =
      std::ranges::all_of(sorted, [&](const auto& slices) { return slices.size() == sorted.front().size(); });
  TimeSteps steps = even ? evenSteps(order, positions, sorted, tags) : completeSteps(order, sorted, tags);
  checkKinds(order, tags, steps);
  return steps;
}

}  // namespace isolux::volume
