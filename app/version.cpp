#include "app/version.h"

namespace isolux::app {

std::string_view version() {
  return ISOLUX_VERSION;
}

}  // namespace isolux::app
