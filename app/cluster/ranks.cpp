#include "app/cluster/ranks.h"

#include <cstdint>

namespace isolux::app {

void broadcastText(Ranks& ranks, std::string& text, const base::Progress& progress) {
  std::uint64_t size = text.size();
  ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)), progress);
  text.resize(size);
  ranks.broadcast(std::as_writable_bytes(std::span(text.data(), text.size())), progress);
}

}  // namespace isolux::app
