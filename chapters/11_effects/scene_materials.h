#pragma once

#include <map>
#include <memory>
#include <string>

#include "material/material.h"
#include "medium/medium.h"
#include "scene_json.h"
#include "texture/normal_map.h"
#include "texture/texture.h"

namespace caustic {

/// The file that a member of a scene's file names: a path from that file's folder.
std::string fileNamedBy(const JsonPlace& place);

/// A colour, or an object that says how it varies.
/// @throws InputError with the place
std::shared_ptr<const Texture> readTexture(const JsonPlace& place);

/// How a surface scatters.
/// @throws InputError with the place
std::shared_ptr<const Material> readMaterial(const JsonPlace& place);

/// What absorbs and scatters within an object.
/// @throws InputError with the place
std::shared_ptr<const Medium> readMedium(const JsonPlace& place);

/// Normals that an image holds.
/// @throws InputError with the place
std::shared_ptr<const NormalMap> readNormalMap(const JsonPlace& place);

/// Things by their names.
template <typename Thing>
using Named = std::map<std::string, std::shared_ptr<const Thing>>;

/// Reads all members of an object that may be missing, each a named thing.
template <typename Thing>
Named<Thing> readNamed(const JsonPlace& scene, const std::string& member,
                       std::shared_ptr<const Thing> (*read)(const JsonPlace&)) {
    Named<Thing> all;
    const auto things = scene.find(member);
    if (!things) return all;
    for (const std::string& name : things->members()) all[name] = read((*things)[name]);
    return all;
}

/// The thing that a member names; null when the member is missing.
/// @throws InputError with the place when there is no such thing
template <typename Thing>
std::shared_ptr<const Thing> namedBy(const std::optional<JsonPlace>& place, const Named<Thing>& things) {
    if (!place) return nullptr;
    const auto found = things.find(place->text());
    if (found != things.end()) return found->second;
    std::string names;
    for (const auto& thing : things) names += (names.empty() ? "" : ", ") + thing.first;
    place->refuse(names.empty() ? "nothing has such a name" : "nothing has such a name; there are " + names);
}

}  // namespace caustic
