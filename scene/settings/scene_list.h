// Describes the lists of a scene whose items have ids and settings of their own, as the light sources.
//
// LIST.ID.FIELD is a setting of an item ("lamps.key.intensity"), LIST.ID the whole item and LIST.order the
// ids in their order. A number in the place of the id means the position, counted from 1. An id is
// [a-z][a-z0-9_]{0,31} and stays when the item is renamed or moved. Assigning the field `maker` to an unknown
// id makes that item, at the end of the list; an only item that nobody has touched becomes that one instead.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/settings/settings.h"

namespace isolux::scene {

struct SceneList {
  std::string path;                   // "lamps"
  std::string noun;                   // of an item, in messages: "light source"
  std::string maker;                  // the field that makes an item: "kind"
  std::string joiner{};               // another; what it makes takes no untouched item's place; "": none
  std::string former;                 // group of the numbered settings of before: "lamp" of "lamp2.kind"
  bool firstHadNoNumber = false;      // of those: "isosurface.value", "isosurface2.value"
  std::string idStem;                 // of ids that newId() makes
  std::size_t least = 0, most = 0;    // items
  std::vector<SettingInfo> fields{};  // paths with ID for the id: "lamps.ID.kind"

  std::function<std::vector<std::string>(const Scene&)> ids{};
  // Leaves the items of these ids in this order; makes those that are not there, with defaults.
  std::function<void(Scene&, const std::vector<std::string>&)> arrange{};
  // Return a field of an item of before the lists at a position, and add such an item at the end.
  std::function<nlohmann::json(std::size_t position, std::size_t field)> formerValue{};
  std::function<void(Scene&, const std::string& id)> addFormer{};
  // Return and assign a field of an item; get() of an unknown id returns the default.
  std::function<nlohmann::json(const Scene&, const std::string& id, std::size_t field)> get{};
  std::function<void(Scene&, const std::string& id, std::size_t field, const nlohmann::json&)> set{};
};

std::span<const SceneList> sceneLists();
// Returns the list that a path belongs to, "lamps.key.kind" or "lamps.order", or null.
const SceneList* listOfPath(std::string_view path);
// Returns the name of a field: "kind" of "lamps.ID.kind".
std::string_view nameOfField(const SceneList& list, const SettingInfo& field);
// Returns the setting of a path into a list, of the whole list ("lamps"), also one of before the lists
// ("lamp2.kind"): numbered items that are not there are made as they were then, switched off, unless the
// value is that of then. Returns nullopt for other paths. Throws Error for an unknown field or no id. The
// setting's set() throws for an unknown item.
std::optional<Setting> itemSetting(std::string_view path);
// Arranges the items as SceneList::arrange() does. Throws Error if an id is none, is there twice, or there
// are too many or too few.
void arrangeChecked(const SceneList& list, Scene& scene, const std::vector<std::string>& ids);
// Returns all settings of the items that a scene has, in order: fields only.
std::vector<Setting> itemSettings(const Scene& scene);
// Returns the path with the id of the item that it names in this scene, "surfaces.main.value" for
// "isosurface.value"; other paths unchanged.
std::string canonicalPath(const Scene& scene, std::string_view path);
// Returns the path with '#' for the item, as the rules name it: "lamps.#.kind"; other paths unchanged.
std::string patternOf(std::string_view path);
// Returns the position of the item of a path into a list, from 0; nullopt if the scene has none such.
std::optional<std::size_t> positionOf(const Scene& scene, std::string_view path);
// Returns the surface that is new at a position, without an id: opaque, in the colour of its place.
Surface newSurface(std::size_t position);
// Returns an id that no item of the list has: "light1", "light2" ... by its position, or of a name: "bone",
// "bone_2".
std::string newId(const SceneList& list, const Scene& scene, std::string_view name = {});

}  // namespace isolux::scene
