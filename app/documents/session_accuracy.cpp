#include "app/documents/session_accuracy.h"

#include <nlohmann/json.hpp>

#include "app/accuracy/accuracy_report.h"

namespace isolux::app {

std::string sessionWithAccuracy(const std::string& session, const Accuracy& accuracy) {
  if (session.empty()) return session;
  auto whole = nlohmann::ordered_json::parse(session);
  whole["accuracy"] = accuracyJson(accuracy);
  return whole.dump(2) + '\n';
}

}  // namespace isolux::app
