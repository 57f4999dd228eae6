#include "bench/pass_times.h"

#include <algorithm>
#include <map>

#include "base/quantiles.h"
#include "bench/bench.h"

namespace isolux::bench {

double PassTimes::of(const std::string& pass) const {
  const auto found =
      std::find_if(passes.begin(), passes.end(), [&](const auto& p) { return p.first == pass; });
  return found == passes.end() ? 0.0 : found->second;
}

std::vector<PassTimes> passTimes(const std::vector<Frame>& frames, int rounds) {
  struct Samples {
    std::vector<double> frame;
    std::map<std::string, std::vector<double>> passes;
  };
  std::vector<Samples> samples(frames.size());
  std::vector<PassTimes> result(frames.size());
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < frames.size(); ++i) {
      frames[i].renderer->invalidate();
      const render::FrameReport& report = frames[i].changed();
      if (round < 0) {
        for (const auto& pass : report.passes)
          if (pass.state == render::PassState::ran) result[i].passes.emplace_back(pass.name, 0.0);
        result[i].activeBlocks = report.blocksActive;
        continue;
      }
      samples[i].frame.push_back(report.milliseconds);
      for (const auto& pass : report.passes)
        if (pass.state == render::PassState::ran) samples[i].passes[pass.name].push_back(pass.milliseconds);
    }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    result[i].frame = base::median(samples[i].frame);
    for (auto& [name, milliseconds] : result[i].passes) milliseconds = base::median(samples[i].passes[name]);
  }
  return result;
}

}  // namespace isolux::bench
