// The accuracy of a picture in the session that it carries: for who looks at it later. It is no setting, and
// parseSession() passes over it.
#pragma once

#include <string>

#include "app/accuracy/accuracy.h"

namespace isolux::app {

// The text of a session (app/documents/session.h) with the figures of `isolux render --stats`; empty stays
// empty.
std::string sessionWithAccuracy(const std::string& session, const Accuracy& accuracy);

}  // namespace isolux::app
