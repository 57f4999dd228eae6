#include "scene/settings/scene_list.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/words.h"
#include "scene/settings/setting_entry.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

constexpr std::string_view kOrder = "order";
constexpr std::string_view kAnyItem = "ID";

// `made`: an item that is new at a position; `former`: one of before the lists, switched off.
template <class Item>
void describe(SceneList& list, std::vector<Item> Scene::*items, SettingList<Item> described,
              Item (*made)(std::size_t position), Item (*former)(std::size_t position)) {
  std::vector<SettingOf<Item>> fields = described.take();
  list.fields.assign(fields.begin(), fields.end());
  const auto find = [items](auto& scene, const std::string& id) {
    return std::ranges::find(scene.*items, id, &Item::id);
  };
  list.ids = [items](const Scene& scene) {
    std::vector<std::string> ids;
    for (const Item& item : scene.*items) ids.push_back(item.id);
    return ids;
  };
  list.arrange = [items, find, made](Scene& scene, const std::vector<std::string>& ids) {
    std::vector<Item> arranged;
    for (const std::string& id : ids) {
      const auto found = find(scene, id);
      if (found != (scene.*items).end()) {
        arranged.push_back(*found);
      } else {
        arranged.push_back(made(arranged.size()));
        arranged.back().id = id;
      }
    }
    scene.*items = std::move(arranged);
  };
  list.get = [items, find, fields](const Scene& scene, const std::string& id, std::size_t field) {
    const auto found = find(scene, id);
    return fields[field].get(found != (scene.*items).end() ? *found : Item{});
  };
  list.formerValue = [former, fields](std::size_t position, std::size_t field) {
    return fields[field].get(former(position));
  };
  list.addFormer = [items, former](Scene& scene, const std::string& id) {
    (scene.*items).push_back(former((scene.*items).size()));
    (scene.*items).back().id = id;
  };
  list.set = [find, fields](Scene& scene, const std::string& id, std::size_t field, const json& value) {
    fields[field].set(*find(scene, id), value);
  };
}

SceneList makeLamps() {
  SettingList<Lamp> fields;
  const std::string group = "lamps.ID.";
  fields.add(group + "shown", ISOLUX_MEMBER(shown), "Switches the light source on.");
  fields.add(group + "name", ISOLUX_MEMBER(name), "Name of the light source, for lists.");
  fields.add(
      group + "kind", ISOLUX_MEMBER(kind),
      "Kind of the light source: point, distant (directional) or sphere light. Assigning it to a new ID "
      "makes a light source.");
  fields.add(
      group + "position", ISOLUX_MEMBER(position), positionRange, "mm",
      "Position of a point or sphere light; auto is above the volume, towards the front and the left.");
  fields.addDirection(group + "direction", ISOLUX_MEMBER(direction),
                      "Direction towards a distant light, world axes; any length but zero.");
  fields.add(group + "radius", ISOLUX_MEMBER(radius), {1e-12, 1e13}, "mm",
             "Radius of a sphere light; a larger one gives softer shadows; auto is a tenth of the volume's "
             "diagonal.");
  fields.add(group + "angle", ISOLUX_MEMBER(angle), {0, 90}, "degrees",
             "Angular diameter of a distant light; the sun has 0.53, 0 gives hard shadows.");
  fields.add(group + "color", ISOLUX_MEMBER(color), unitRange, "linear RGB", "Colour of the light source.");
  fields.add(group + "intensity", ISOLUX_MEMBER(intensity), {0, 1e6}, "",
             "Brightness of a white surface that faces the light source at the volume's centre.");
  fields.add(group + "shadows", ISOLUX_MEMBER(shadows),
             "The light source casts shadows; off, its light reaches every point that faces it, and "
             "reflected light stays.");
  SceneList list{.path = "lamps",
                 .noun = "light source",
                 .maker = "kind",
                 .former = "lamp",
                 .idStem = "light",
                 .most = kLamps};
  describe<Lamp>(
      list, &Scene::lamps, std::move(fields), [](std::size_t) { return Lamp{}; },
      [](std::size_t) { return Lamp{.shown = false}; });
  return list;
}

// The colours of surfaces behind the first, in turn.
constexpr glm::dvec3 kAlbedos[] = {{0.25, 0.45, 0.75}, {0.30, 0.62, 0.35}, {0.75, 0.28, 0.22},
                                   {0.80, 0.58, 0.16}, {0.45, 0.30, 0.68}, {0.20, 0.60, 0.62},
                                   {0.78, 0.42, 0.60}, {0.50, 0.62, 0.20}, {0.52, 0.38, 0.28},
                                   {0.42, 0.60, 0.82}, {0.82, 0.50, 0.36}};

SceneList makeSurfaces() {
  SettingList<Surface> fields;
  const std::string group = "surfaces.ID.";
  fields.add(group + "shown", ISOLUX_MEMBER(shown), "Draws the surface.");
  fields.add(group + "name", ISOLUX_MEMBER(name), "Name of the surface in lists and on the histogram.");
  fields.add(
      group + "value", ISOLUX_MEMBER(value), {-1e38, 1e38}, "data units",
      "Isovalue of the surface. auto: the first follows isosurface.suggestion, others take the "
      "histogram's next suggestion outside the first, or inside if there is none. Assigning it to a new "
      "ID makes a surface.");
  fields.add(group + "labels", ISOLUX_MEMBER(labels),
             "Labels of a label map that this surface encloses, as in source.labels; the first surface "
             "without any encloses all that no other names. Assigning it to a new ID makes a surface.");
  fields.add(group + "smoothing", ISOLUX_MEMBER(smoothing), {0, 2}, "voxels",
             "Smoothing of this surface of labels, as in source.smoothing; auto is that.");
  fields.add(group + "label_colors", ISOLUX_MEMBER(labelColors),
             "Gives each label on the surface its own colour; off, the surface has its albedo.");
  fields.add(group + "albedo", ISOLUX_MEMBER(albedo), unitRange, "linear RGB",
             "Diffuse reflectance of the surface.");
  fields.add(group + "specular", ISOLUX_MEMBER(specular), unitRange, "",
             "Gloss under global illumination: reflectance of the surface seen head on. Water and skin have "
             "0.02 to 0.04, teeth 0.06, metal 0.5 to 0.9; 0 is matt.");
  fields.add(group + "roughness", ISOLUX_MEMBER(roughness), {0.05, 1.0}, "",
             "Roughness of that gloss: small values reflect sharply, 1 spreads over half the sky.");
  fields.add(group + "opacity", ISOLUX_MEMBER(opacity), unitRange, "",
             "Opacity of the surface; 1 hides everything behind it.");
  fields.add(group + "facing_opacity", ISOLUX_MEMBER(facingOpacity), unitRange, "",
             "View-dependent opacity: factor on the opacity where the surface faces the viewer; edge-on the "
             "opacity is unchanged.");
  fields.add(group + "ghost", ISOLUX_MEMBER(ghost), {0, 100}, "standard deviations of the noise",
             "Draws two uncertainty surfaces: transparent isosurfaces at the isovalue ± this many standard "
             "deviations of the noise. They bound the shift due to noise; 0 draws none.");
  fields.add(group + "clipped", ISOLUX_MEMBER(clipped), "Applies clip planes and clip box to the surface.");
  SceneList list{.path = "surfaces",
                 .noun = "surface",
                 .maker = "value",
                 .joiner = "labels",
                 .former = "isosurface",
                 .firstHadNoNumber = true,
                 .idStem = "surface",
                 .least = 1,
                 .most = kSurfaces};
  describe<Surface>(list, &Scene::surfaces, std::move(fields), newSurface, [](std::size_t position) {
    Surface surface = newSurface(position);
    if (position == 0) return surface;
    surface.shown = false;
    surface.opacity = 0.5;
    return surface;
  });
  return list;
}

bool isId(std::string_view text) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !text.empty() && text.size() <= 32 && letter(text[0]) && text != kOrder &&
         std::ranges::all_of(text, [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

// From 0; nullopt: no position.
std::optional<std::size_t> asPosition(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number == 0) return std::nullopt;
  return number - 1;
}

struct PathParts {
  const SceneList* list = nullptr;
  std::string_view item;   // id or position
  std::string_view field;  // empty: the whole item
  bool former = false;
};

std::optional<std::size_t> findField(const SceneList& list, std::string_view name) {
  const auto isNamed = [&](const SettingInfo& field) { return nameOfField(list, field) == name; };
  const auto found = std::ranges::find_if(list.fields, isNamed);
  if (found == list.fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.fields.begin());
}

std::optional<PathParts> partsOf(std::string_view path) {
  for (const SceneList& list : sceneLists()) {
    const std::size_t dot = path.find('.');
    const std::string_view group = path.substr(0, dot);
    const std::string_view rest = dot == std::string_view::npos ? "" : path.substr(dot + 1);
    if (group == list.path && !rest.empty()) {
      const std::size_t end = std::min(rest.find('.'), rest.size());
      return PathParts{&list, rest.substr(0, end), rest.substr(std::min(end + 1, rest.size()))};
    }
    if (rest.empty() || !group.starts_with(list.former)) continue;
    const std::string_view number = group.substr(list.former.size());
    if (list.firstHadNoNumber && number.empty() && findField(list, rest))
      return PathParts{&list, "1", rest, true};
    if (const auto position = asPosition(number); position && !(list.firstHadNoNumber && *position == 0))
      return PathParts{&list, number, rest, true};
  }
  return std::nullopt;
}

std::size_t fieldNamed(const SceneList& list, std::string_view name, std::string_view path) {
  if (const auto field = findField(list, name)) return *field;
  std::vector<std::string> names;
  for (const SettingInfo& field : list.fields) names.emplace_back(nameOfField(list, field));
  refuse(std::string(path.substr(0, 200)),
         "unknown setting of a " + list.noun + base::didYouMean(std::string(name.substr(0, 200)), names, ""));
}

// The id of an item; empty: the scene has none at that position.
std::string idOf(const SceneList& list, const Scene& scene, std::string_view item) {
  const std::optional<std::size_t> position = asPosition(item);
  if (!position) return std::string(item);
  const std::vector<std::string> ids = list.ids(scene);
  return *position < ids.size() ? ids[*position] : "";
}

bool hasItem(const SceneList& list, const Scene& scene, const std::string& id) {
  return std::ranges::count(list.ids(scene), id) > 0;
}

[[noreturn]] void refuseId(std::string_view path) {
  refuse(std::string(path.substr(0, 200)),
         "an id has up to 32 of a to z, 0 to 9 and '_', a letter first, and is not \"order\"");
}

void checkCount(const SceneList& list, std::size_t count, const std::string& path) {
  if (count < list.least) refuse(path, "a scene has at least one " + list.noun);
  if (count > list.most)
    refuse(path, "a scene has at most " + std::to_string(list.most) + ' ' + list.noun + 's');
}

// Whether the only item is as in a new scene.
bool isUntouched(const SceneList& list, const Scene& scene) {
  const Scene fresh;
  const std::vector<std::string> ids = list.ids(fresh);
  if (ids.empty() || list.ids(scene) != ids) return false;
  for (std::size_t field = 0; field < list.fields.size(); ++field)
    if (list.get(scene, ids[0], field) != list.get(fresh, ids[0], field)) return false;
  return true;
}

void addItem(const SceneList& list, Scene& scene, const std::string& id, const std::string& path) {
  std::vector<std::string> ids = list.ids(scene);
  ids.push_back(id);
  checkCount(list, ids.size(), path);
  list.arrange(scene, ids);
}

// As a user does who names that field of it: an only item that nobody has touched becomes that one, unless it
// joins the others.
void makeItem(const SceneList& list, Scene& scene, const std::string& id, std::string_view field,
              const std::string& path) {
  if (field == list.maker && isUntouched(list, scene))
    list.arrange(scene, {id});
  else
    addItem(list, scene, id, path);
}

bool makesItem(const SceneList& list, std::string_view field) {
  return field == list.maker || (!list.joiner.empty() && field == list.joiner);
}

[[noreturn]] void refuseItem(const SceneList& list, const Scene& scene, std::string_view item,
                             const std::string& path) {
  const std::vector<std::string> ids = list.ids(scene);
  std::string reason =
      "there is no " + list.noun + ' ' + std::string(item) + base::didYouMean(std::string(item), ids, "");
  if (isId(item)) reason += "; " + list.path + '.' + std::string(item) + '.' + list.maker + "=... makes it";
  refuse(path, reason);
}

// Numbered settings of before: items up to this one are there, switched off.
std::string formerItem(const SceneList& list, Scene& scene, std::size_t position, const std::string& path) {
  checkCount(list, position + 1, path);
  while (list.ids(scene).size() <= position) list.addFormer(scene, newId(list, scene));
  return list.ids(scene)[position];
}

Setting fieldSetting(const PathParts& parts, std::string_view path) {
  const SceneList& list = *parts.list;
  const std::size_t field = fieldNamed(list, parts.field, path);
  Setting setting{list.fields[field], {}, {}};
  setting.path = path;
  const std::string item(parts.item);
  setting.get = [&list, item, field, former = parts.former](const Scene& scene) {
    const std::string id = idOf(list, scene, item);
    if (former && !hasItem(list, scene, id)) return list.formerValue(*asPosition(item), field);
    return list.get(scene, id, field);
  };
  setting.set = [&list, item, field, former = parts.former, info = SettingInfo(setting)](Scene& scene,
                                                                                         const json& value) {
    Scene changed = scene;  // nothing is made for a value that is refused
    std::string id = idOf(list, scene, item);
    const bool there = hasItem(list, scene, id);
    if (!there && former && value == list.formerValue(*asPosition(item), field)) return;
    if (!there && former)
      id = formerItem(list, changed, *asPosition(item), info.path);
    else if (!there && isId(item) && makesItem(list, nameOfField(list, list.fields[field])))
      makeItem(list, changed, id, nameOfField(list, list.fields[field]), info.path);
    else if (!there)
      refuseItem(list, scene, item, info.path);
    try {
      list.set(changed, id, field, value);
    } catch (const base::Error& error) {  // with the path that was asked for
      refuse(info.path, error.reason());
    }
    scene = std::move(changed);
  };
  return setting;
}

// The object of an item within another; fields of a group are in an object of their own.
json objectOf(const SceneList& list, const Scene& scene, const std::string& id) {
  json object = json::object();
  for (std::size_t field = 0; field < list.fields.size(); ++field)
    object[std::string(nameOfField(list, list.fields[field]))] = list.get(scene, id, field);
  return object;
}

Setting wholeSetting(const PathParts& parts, std::string_view path) {
  const SceneList& list = *parts.list;
  Setting setting;
  setting.path = path;
  setting.type = SettingType::item;
  setting.meaning = "The whole " + list.noun + " as an object of its settings; none removes it.";
  const std::string item(parts.item);
  setting.get = [&list, item](const Scene& scene) {
    const std::string id = idOf(list, scene, item);
    return hasItem(list, scene, id) ? objectOf(list, scene, id) : json();
  };
  setting.set = [&list, item, path = setting.path](Scene& scene, const json& value) {
    const std::string id = idOf(list, scene, item);
    const bool there = hasItem(list, scene, id);
    if (value.is_null() && !there) refuseItem(list, scene, item, path);
    if (!value.is_null() && !value.is_object()) refuse(path, "must be an object of its settings, or none");
    if (!there && !isId(item)) refuseItem(list, scene, item, path);
    std::vector<std::string> ids = list.ids(scene);
    Scene changed = scene;
    if (value.is_null()) {
      std::erase(ids, id);
      checkCount(list, ids.size(), path);
      list.arrange(changed, ids);
    } else {
      if (!there) addItem(list, changed, id, path);
      for (std::size_t field = 0; field < list.fields.size(); ++field)
        list.set(changed, id, field, list.get(Scene{}, "", field));
      for (const auto& [name, given] : value.items())
        if (name != "id")
          itemSetting(std::string(list.path).append(".").append(id).append(".").append(name))
              ->set(changed, given);
    }
    scene = std::move(changed);
  };
  return setting;
}

// The whole list: each item with its id.
Setting listSetting(const SceneList& list) {
  Setting setting;
  setting.path = list.path;
  setting.type = SettingType::item;
  setting.meaning = "All " + list.noun + "s as a list of objects, each with its \"id\".";
  setting.get = [&list](const Scene& scene) {
    json items = json::array();
    for (const std::string& id : list.ids(scene)) {
      items.push_back(objectOf(list, scene, id));
      items.back()["id"] = id;
    }
    return items;
  };
  setting.set = [&list](Scene& scene, const json& value) {
    if (!value.is_array()) refuse(list.path, "must be a list");
    std::vector<std::string> ids;
    for (const json& item : value) {
      const auto id = item.is_object() ? item.find("id") : item.end();
      if (!item.is_object() || id == item.end() || !id->is_string())
        refuse(list.path, "each " + list.noun + " must be an object with an \"id\"");
      ids.push_back(id->get<std::string>());
    }
    Scene changed = scene;
    arrangeChecked(list, changed, ids);
    for (const json& item : value)
      itemSetting(list.path + '.' + item["id"].get<std::string>())->set(changed, item);
    scene = std::move(changed);
  };
  return setting;
}

Setting orderSetting(const SceneList& list, std::string_view path) {
  Setting setting;
  setting.path = path;
  setting.type = SettingType::ids;
  setting.meaning = "The ids of all " + list.noun + "s in their order.";
  setting.get = [&list](const Scene& scene) { return json(list.ids(scene)); };
  setting.set = [&list, path = setting.path](Scene& scene, const json& value) {
    std::vector<std::string> ids;
    for (const json& id : value.is_array() ? value : json::array())
      if (id.is_string()) ids.push_back(id.get<std::string>());
    std::vector<std::string> wanted = ids, known = list.ids(scene);
    std::ranges::sort(wanted);
    std::ranges::sort(known);
    if (!value.is_array() || ids.size() != value.size() || wanted != known)
      refuse(path, "must name each " + list.noun + " once: " + base::joined(list.ids(scene)));
    list.arrange(scene, ids);
  };
  return setting;
}

}  // namespace

std::span<const SceneList> sceneLists() {
  static const std::vector<SceneList> lists{makeSurfaces(), makeLamps()};
  return lists;
}

const SceneList* listOfPath(std::string_view path) {
  const std::optional<PathParts> parts = partsOf(path);
  return parts && !parts->former ? parts->list : nullptr;
}

std::string_view nameOfField(const SceneList& list, const SettingInfo& field) {
  return std::string_view(field.path).substr(list.path.size() + kAnyItem.size() + 2);
}

std::optional<Setting> itemSetting(std::string_view path) {
  for (const SceneList& list : sceneLists())
    if (path == list.path) return listSetting(list);
  const std::optional<PathParts> parts = partsOf(path);
  if (!parts) return std::nullopt;
  if (!parts->former && parts->item == kOrder && parts->field.empty())
    return orderSetting(*parts->list, path);
  if (!isId(parts->item) && !asPosition(parts->item)) refuseId(path);
  return parts->field.empty() ? wholeSetting(*parts, path) : fieldSetting(*parts, path);
}

void arrangeChecked(const SceneList& list, Scene& scene, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (!isId(id)) refuseId(list.path + '.' + id);
    if (std::ranges::count(ids, id) > 1) refuse(list.path + '.' + id, "is there twice");
  }
  checkCount(list, ids.size(), list.path);
  list.arrange(scene, ids);
}

std::vector<Setting> itemSettings(const Scene& scene) {
  std::vector<Setting> settings;
  for (const SceneList& list : sceneLists())
    for (const std::string& id : list.ids(scene))
      for (const SettingInfo& field : list.fields)
        settings.push_back(*itemSetting(
            std::string(list.path).append(".").append(id).append(".").append(nameOfField(list, field))));
  return settings;
}

std::string canonicalPath(const Scene& scene, std::string_view path) {
  const std::optional<PathParts> parts = partsOf(path);
  const std::string id = parts && parts->item != kOrder ? idOf(*parts->list, scene, parts->item) : "";
  if (id.empty()) return std::string(path);
  const std::string item = parts->list->path + '.' + id;
  return parts->field.empty() ? item : (item + '.').append(parts->field);
}

std::string patternOf(std::string_view path) {
  const std::optional<PathParts> parts = partsOf(path);
  if (!parts || parts->field.empty()) return std::string(path);
  return parts->list->path + ".#." + std::string(parts->field);
}

std::optional<std::size_t> positionOf(const Scene& scene, std::string_view path) {
  const std::optional<PathParts> parts = partsOf(path);
  if (!parts) return std::nullopt;
  const std::vector<std::string> ids = parts->list->ids(scene);
  const auto found = std::ranges::find(ids, idOf(*parts->list, scene, parts->item));
  if (found == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ids.begin());
}

Surface newSurface(std::size_t position) {
  if (position == 0) return {};
  return {.albedo = kAlbedos[(position - 1) % std::size(kAlbedos)]};
}

std::string newId(const SceneList& list, const Scene& scene, std::string_view name) {
  std::string stem;
  for (const char letter : base::lowerCase(std::string(name)))
    if (isId(stem + letter) || (!stem.empty() && letter == ' ')) stem += letter == ' ' ? '_' : letter;
  if (stem.size() > 28) stem.resize(28);
  if (isId(stem) && !hasItem(list, scene, stem)) return stem;
  stem = isId(stem) ? stem + '_' : list.idStem;
  const int first = stem.ends_with('_') ? 2 : static_cast<int>(list.ids(scene).size()) + 1;
  for (int number = first;; ++number) {
    std::string id = stem + std::to_string(number);
    if (!hasItem(list, scene, id)) return id;
  }
}

}  // namespace isolux::scene
