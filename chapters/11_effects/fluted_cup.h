#pragma once

#include <filesystem>
#include <optional>

#include "scene/scene_description.h"
#include "texture/image_texture.h"

namespace caustic {

/// A cup of glass whose outside a normal map of few pixels makes fluted, on a table under a spotlight, and its caustic.
/// y is up, metres.
/// @param lookup   of the map; none for a smooth cup
/// @param profile  the drawing of a cup
/// @throws InputError as loadOutline does
SceneDescription flutedCup(std::optional<Lookup> lookup, const std::filesystem::path& profile, int width, int height);

/// The same without the sky, from straight above beside the cup: the table alone, a square with the caustic in it.
SceneDescription flutedCupsCaustic(std::optional<Lookup> lookup, const std::filesystem::path& profile, int side);

}  // namespace caustic
