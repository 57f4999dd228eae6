#include "render/graph/frame_graph.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace isolux::render {

namespace {
std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

// A change of the look changes many settings that a pass depends on: the first few say enough.
std::string reasonOf(std::vector<std::string> changes) {
  constexpr std::size_t most = 4;
  if (changes.size() <= most) return joined(changes);
  const std::size_t more = changes.size() - (most - 1);
  changes.resize(most - 1);
  changes.push_back(std::to_string(more) + " more");
  return joined(changes);
}
}  // namespace

std::vector<bool> usedPasses(const std::vector<PassDeclaration>& passes,
                             const std::vector<std::string>& wanted) {
  std::set<std::string> needed(wanted.begin(), wanted.end());
  std::vector<bool> used(passes.size(), false);
  for (std::size_t i = passes.size(); i-- > 0;) {
    const PassDeclaration& pass = passes[i];
    used[i] = std::any_of(pass.writes.begin(), pass.writes.end(),
                          [&](const std::string& image) { return needed.count(image) > 0; });
    if (used[i]) needed.insert(pass.reads.begin(), pass.reads.end());
  }
  return used;
}

std::map<std::string, std::size_t> lastUses(const std::vector<PassDeclaration>& passes,
                                            const std::vector<PlannedPass>& plan,
                                            const std::vector<std::string>& wanted) {
  std::map<std::string, std::size_t> last;
  for (const PlannedPass& planned : plan) {
    if (planned.state != PassState::ran) continue;
    const PassDeclaration& pass = passes[planned.index];
    for (const std::string& image : pass.reads) last[image] = planned.index;
    for (const std::string& image : pass.writes) last[image] = planned.index;
  }
  for (const std::string& image : wanted) last[image] = passes.size();
  // An image lasts as long as its other name.
  for (const PlannedPass& planned : plan) {
    const PassDeclaration& pass = passes[planned.index];
    for (std::size_t i = 1; planned.state != PassState::skipped && i < pass.bytes.size(); ++i) {
      const auto name = last.find(pass.writes[i]);
      if (pass.bytes[i] != PassDeclaration::kSameImage || name == last.end()) continue;
      std::size_t& own = last[pass.writes[i - 1]];
      own = std::max(own, name->second);
    }
  }
  return last;
}

int peakBytesPerRay(const std::vector<PassDeclaration>& passes, const std::vector<std::string>& wanted) {
  const std::vector<bool> used = usedPasses(passes, wanted);
  std::vector<PlannedPass> plan;
  for (std::size_t i = 0; i < passes.size(); ++i)
    plan.push_back({i, used[i] ? PassState::ran : PassState::skipped, ""});
  const auto last = lastUses(passes, plan, wanted);
  std::map<std::string, int> held;
  int peak = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (!used[i]) continue;
    for (std::size_t k = 0; k < passes[i].bytes.size(); ++k)
      held[passes[i].writes[k]] = std::max(passes[i].bytes[k], 0);
    int sum = 0;
    for (const auto& [image, bytes] : held) sum += bytes;
    peak = std::max(peak, sum);
    std::erase_if(held, [&](const auto& image) { return last.at(image.first) <= i; });
  }
  return peak;
}

std::uint64_t FrameGraph::versionOf(const std::string& image) const {
  const auto writer = writers_.find(image);
  if (writer == writers_.end()) return 0;
  const auto found = versions_.find({image, writer->second});
  return found == versions_.end() ? 0 : found->second;
}

std::vector<PlannedPass> FrameGraph::plan(const std::vector<PassDeclaration>& passes,
                                          const std::vector<std::string>& wanted) {
  const std::vector<bool> used = usedPasses(passes, wanted);
  // Forwards: what has changed.
  std::vector<PlannedPass> planned;
  std::set<std::string> renewed, written;
  writers_.clear();
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const PassDeclaration& pass = passes[i];
    written.insert(pass.writes.begin(), pass.writes.end());
    if (!used[i]) {
      planned.push_back(
          {i, PassState::skipped,
           pass.notNeeded.empty() ? "nothing reads its " + joined(pass.writes) : pass.notNeeded});
      continue;
    }
    for (const std::string& image : pass.writes) writers_[image] = pass.name;
    std::vector<std::string> changed;
    const auto last = memory_.find(pass.name);
    if (last == memory_.end()) {
      changed.emplace_back("first use");
    } else {
      for (const Parameter& parameter : pass.parameters) {
        const auto before = std::find_if(last->second.parameters.begin(), last->second.parameters.end(),
                                         [&](const Parameter& p) { return p.name == parameter.name; });
        if (before == last->second.parameters.end() || before->hash != parameter.hash)
          changed.push_back(parameter.name + " changed");
      }
      for (const std::string& image : pass.reads) {
        assert(written.count(image) > 0 && "an image is read before a pass writes it");
        const auto before = std::find_if(last->second.inputs.begin(), last->second.inputs.end(),
                                         [&](const auto& input) { return input.first == image; });
        if (renewed.count(image) > 0 || before == last->second.inputs.end() ||
            before->second != versionOf(image))
          changed.push_back(image + " drawn anew");
      }
    }
    if (changed.empty()) {
      planned.push_back({i, PassState::cached, "nothing it depends on changed"});
    } else {
      renewed.insert(pass.writes.begin(), pass.writes.end());
      planned.push_back({i, PassState::ran, reasonOf(std::move(changed))});
    }
  }
  remakeFreed(passes, wanted, planned);
  return planned;
}

// Backwards: what running passes need of freed images.
void FrameGraph::remakeFreed(const std::vector<PassDeclaration>& passes,
                             const std::vector<std::string>& wanted,
                             std::vector<PlannedPass>& planned) const {
  if (freed_.empty()) return;
  std::set<std::string> needed(wanted.begin(), wanted.end());
  for (std::size_t i = passes.size(); i-- > 0;) {
    const PassDeclaration& pass = passes[i];
    PlannedPass& now = planned[i];
    const bool isNeeded = std::any_of(pass.writes.begin(), pass.writes.end(),
                                      [&](const std::string& image) { return needed.count(image) > 0; });
    if (now.state == PassState::cached && isNeeded && freed_.count(pass.name) > 0)
      now = {i, PassState::ran, "its images were freed", true};
    if (now.state == PassState::ran) needed.insert(pass.reads.begin(), pass.reads.end());
  }
}

void FrameGraph::completed(const PassDeclaration& pass) {
  // The same inputs make the same images: those that have read them stay cached.
  if (freed_.erase(pass.name) > 0 && memory_.count(pass.name) > 0) return;
  LastRun run{pass.parameters, {}};
  for (const std::string& image : pass.reads) run.inputs.emplace_back(image, versionOf(image));
  memory_[pass.name] = std::move(run);
  for (const std::string& image : pass.writes) versions_[{image, pass.name}] = ++clock_;
}

}  // namespace isolux::render
