#include "app/documents/command_text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/words.h"
#include "scene/rules/needs.h"
#include "scene/settings/scene_diff.h"

namespace isolux::app {

namespace {

std::string wordOfValue(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number_float()) return base::shortestText(value.get<double>());
  const bool numbers = value.is_array() && !value.empty() &&
                       std::ranges::all_of(value, [](const auto& v) { return v.is_number(); });
  if (!numbers) return value.dump();
  return base::joined(value, ",", wordOfValue);
}

}  // namespace

std::string shellWord(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return (c < 128 && std::isalnum(c)) ||
           std::string_view("_./:=,+@%-").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string assignmentText(const std::string& path, const nlohmann::json& value) {
  return path + "=" + wordOfValue(value);
}

std::string renderCommand(const scene::Scene& scene, const scene::HostSettings& host, glm::ivec2 size,
                          const std::string& out) {
  const std::string& source = scene.source.path;
  const bool isFile = !source.starts_with("phantom:");
  std::string line =
      "isolux render " +
      shellWord(isFile ? std::filesystem::absolute(source).lexically_normal().string() : source);
  const auto add = [&](const std::string& path, const nlohmann::json& value) {
    line += " --set " + shellWord(assignmentText(path, value));
  };
  for (const scene::SceneChange& change : scene::assignmentsOf(scene))
    if (change.path != "source.path") add(change.path, change.value);
  const scene::HostSetting* const executor = scene::hostSetting("picture.executor");
  if (executor != nullptr && host.executor != scene::HostSettings{}.executor)
    add(executor->path, executor->get(host));
  if (scene::usesGi(scene)) line += " --light-around";  // as in the window
  return line + " --size " + std::to_string(size.x) + "x" + std::to_string(size.y) + " --out " +
         shellWord(out);
}

}  // namespace isolux::app
