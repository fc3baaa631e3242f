#pragma once

#include <filesystem>
#include <string_view>

#include "integrator/integrator.h"

namespace caustic {

/// Writes a rendering and what its integrator keeps, so that it can go on later as if it hadn't stopped.
/// @param picture  names what is rendered: scene, method, seed, and whatever else makes the picture another one
/// @throws InputError when the file can't be written; one that was there before then stays as it was
void saveCheckpoint(const std::filesystem::path& file, std::string_view picture, const Rendering& rendering,
                    const Integrator& integrator);

/// Reads what saveCheckpoint wrote.
/// @param integrator  made as that which was saved was: takes what that had kept
/// @throws InputError that names the file when it is missing, no checkpoint, of another version, size or picture, cut
///         short or damaged; the integrator must not be used any more then
Rendering loadCheckpoint(const std::filesystem::path& file, std::string_view picture, Integrator& integrator);

/// The same from any stream of bytes, which has to end with it.
Rendering loadCheckpoint(ByteReader& from, std::string_view picture, Integrator& integrator);

}  // namespace caustic
