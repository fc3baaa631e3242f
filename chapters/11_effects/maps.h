#pragma once

#include <filesystem>
#include <memory>

#include "image/image.h"
#include "light/light.h"

namespace caustic {

/// Reads a panorama. What its compression has left below 0, around bright spots, is 0.
/// @throws InputError as loadImage does
Image loadPanorama(const std::filesystem::path& file);

/// A clear evening sky over a dark ground with a low sun: nearly all its light comes from a few pixels of it.
/// @param height  rows; twice as many columns
Image sunnySky(int height);

/// A panorama whose directions are sampled evenly, whatever it shows: what sampling by brightness is held against.
/// @param map  as environmentLight makes it
std::shared_ptr<Light> evenlySampled(std::shared_ptr<Light> map);

}  // namespace caustic
