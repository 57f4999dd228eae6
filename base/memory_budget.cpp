#include "base/memory_budget.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include "base/decimal_text.h"

namespace isolux::base {

namespace {

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

std::size_t lessOf(std::size_t all, std::size_t taken) {
  return all - std::min(all, taken);
}

#ifdef __linux__

// The number at the beginning of a file; kUnknown where there is none ("max", no such file).
std::size_t numberIn(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::uint64_t number = 0;
  return stream >> number ? static_cast<std::size_t>(number) : kUnknown;
}

// The number behind `key` in a file of lines "key number", 0 where there is none.
std::size_t numberOf(const std::filesystem::path& file, std::string_view key) {
  std::ifstream stream(file);
  std::string word;
  while (stream >> word)
    if (std::uint64_t number = 0; word == key && stream >> number) return static_cast<std::size_t>(number);
  return 0;
}

// Memory that can be had without swapping, pages of files that may be dropped included.
std::size_t leftOfMachine() {
  const std::size_t kib = numberOf("/proc/meminfo", "MemAvailable:");
  return kib == 0 ? kUnknown : kib * 1024;
}

std::size_t leftOfAddressSpace() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  const std::size_t pages = numberIn("/proc/self/statm");
  const std::size_t taken = pages == kUnknown ? 0 : pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return lessOf(limit.rlim_cur, taken);
}

// A group's limit less what it uses and could not drop.
std::size_t leftOfGroup(const std::filesystem::path& group, const char* limitName, const char* usageName) {
  const std::size_t limit = numberIn(group / limitName), usage = numberIn(group / usageName);
  if (limit == kUnknown || usage == kUnknown) return kUnknown;
  return lessOf(limit, lessOf(usage, numberOf(group / "memory.stat", "inactive_file")));
}

// Each group around this process may have a limit: lines "0::/a/b" (version 2), "4:memory:/a/b" (version 1).
std::size_t leftOfGroups() {
  namespace fs = std::filesystem;
  std::size_t least = kUnknown;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const bool two = line.starts_with("0::");
    const std::size_t colon = line.rfind(":/");
    if (colon == std::string::npos || (!two && line.find(":memory:") == std::string::npos)) continue;
    const fs::path root = two ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    fs::path below = fs::path(line.substr(colon + 2));
    for (;; below = below.parent_path()) {
      least =
          std::min(least, two ? leftOfGroup(root / below, "memory.max", "memory.current")
                              : leftOfGroup(root / below, "memory.limit_in_bytes", "memory.usage_in_bytes"));
      if (below.empty()) break;
    }
  }
  return least;
}

#endif

}  // namespace

MemoryBudget::Held::Held(MemoryBudget* budget, std::size_t bytes) noexcept
    : budget_(bytes > 0 ? budget : nullptr), bytes_(budget_ ? bytes : 0) {
  if (budget_) budget_->held_.fetch_add(bytes_, std::memory_order_relaxed);
}

void MemoryBudget::Held::release() noexcept {
  if (budget_) budget_->held_.fetch_sub(bytes_, std::memory_order_relaxed);
  budget_ = nullptr;
  bytes_ = 0;
}

void MemoryBudget::Held::add(Held other) noexcept {
  if (!budget_) std::swap(budget_, other.budget_);
  bytes_ += std::exchange(other.bytes_, 0);
}

void MemoryBudget::Held::shrinkTo(std::size_t bytes) noexcept {
  if (bytes >= bytes_) return;
  budget_->held_.fetch_sub(bytes_ - bytes, std::memory_order_relaxed);
  bytes_ = bytes;
}

bool MemoryBudget::systemHas(std::size_t bytes) const {
  constexpr std::size_t reserve = std::size_t{32} << 20;
  return !systemLeft_ || bytes <= lessOf(systemLeft_(), reserve);
}

std::size_t MemoryBudget::left() const noexcept {
  return lessOf(limit(), held());
}

std::optional<MemoryBudget::Held> MemoryBudget::tryReserve(std::size_t bytes) {
  std::size_t before = held_.load(std::memory_order_relaxed);
  do {
    if (bytes > lessOf(limit(), before)) return std::nullopt;
    constexpr std::size_t step = std::size_t{64} << 20;
    if (before / step != (before + bytes) / step && !systemHas(bytes)) return std::nullopt;
  } while (!held_.compare_exchange_weak(before, before + bytes, std::memory_order_relaxed));
  Held held;
  held.budget_ = this;
  held.bytes_ = bytes;
  return held;
}

MemoryBudget::Held MemoryBudget::reserve(std::size_t bytes, std::string_view what, std::string_view remedy) {
  std::optional<Held> held = tryReserve(bytes);
  if (!held) throw refusal(bytes, what, remedy);
  return std::move(*held);
}

void MemoryBudget::check(std::size_t bytes, std::string_view what, std::string_view remedy) const {
  if (bytes > left() || !systemHas(bytes)) throw refusal(bytes, what, remedy);
}

Error MemoryBudget::refusal(std::size_t bytes, std::string_view what, std::string_view remedy) const {
  if (bytes > left())
    return {ErrorKind::memory, "", "", overBudgetText(bytes, held(), limit(), what, remedy)};
  std::string text = "out of memory for " + std::string(what) + ": " + memoryText(bytes) + " needed, " +
                     memoryText(systemLeft_ ? systemLeft_() : 0) + " left in the system";
  if (!remedy.empty()) text += "; " + std::string(remedy);
  return {ErrorKind::memory, "", "", text};
}

std::string overBudgetText(std::size_t bytes, std::size_t held, std::size_t limit, std::string_view what,
                           std::string_view remedy) {
  std::string text = "out of memory for " + std::string(what) + ": " + memoryText(bytes) + " needed";
  if (held > 0) text += ", " + memoryText(held) + " in use";
  text += ", memory budget of " + memoryText(limit) + "; ";
  if (!remedy.empty()) text += std::string(remedy) + ", or ";
  return text + "raise --memory-budget";
}

MemoryBudget& machineMemory() {
  static MemoryBudget budget(allowedMemory(), systemMemoryLeft);
  return budget;
}

std::size_t addressSpaceLeft() {
#ifdef __linux__
  return leftOfAddressSpace();
#else
  return kUnknown;
#endif
}

std::size_t systemMemoryLeft() {
  std::size_t left = kUnknown;
#ifdef __linux__
  left = std::min({leftOfMachine(), leftOfAddressSpace(), leftOfGroups()});
#endif
  constexpr std::size_t unknownMachine = std::size_t{8} << 30;
  return left == kUnknown ? unknownMachine : left;
}

std::size_t allowedMemory() {
  constexpr std::size_t leastReserve = std::size_t{64} << 20, mostReserve = std::size_t{1} << 30;
  const std::size_t left = systemMemoryLeft();
  return lessOf(left, std::clamp(left / 8, leastReserve, mostReserve));
}

std::size_t parseMemorySize(const std::string& text) {
  const auto refuse = [&]() -> std::size_t {
    throwUsage("", "--memory-budget",
               '"' + text + "\" is not a size: a number of bytes, or with K, M, G or T behind it, as 16G");
  };
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  if (failure != std::errc{} || !(number > 0.0)) return refuse();
  std::string unit(rest, end);
  std::erase(unit, ' ');
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (unit.ends_with("ib")) unit.resize(unit.size() - 2);
  if (unit.ends_with("b")) unit.pop_back();
  static constexpr std::string_view units = "kmgt";
  const std::size_t power = unit.empty() ? 0 : units.find(unit[0]) + 1;
  if (unit.size() > 1 || (power == 0 && !unit.empty())) return refuse();
  const double bytes = std::ldexp(number, static_cast<int>(10 * power));
  return bytes < 0x1p62 ? static_cast<std::size_t>(bytes) : refuse();
}

std::string memoryText(std::size_t bytes) {
  constexpr std::array<const char*, 5> units{"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1024.0 && unit + 1 < units.size(); ++unit) value /= 1024.0;
  return fixedText(value, unit == 0 ? 0 : 1) + ' ' + units[unit];
}

}  // namespace isolux::base
