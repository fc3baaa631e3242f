#pragma once

#include <string_view>

#include "camera/film.h"
#include "scene/ray_counts.h"

namespace caustic {

/// A picture on its way, and what it has cost so far.
struct Rendering {
    Film film;                ///< what the passes have gathered
    RayCounts counts;         ///< what was done in the scene
    std::int64_t passes = 0;  ///< that it is made of
    double seconds = 0;       ///< of computing time that they took, as render() measures it

    /// Adds further passes. Merged in the order of the passes, their pictures make the same one, bit for bit, as
    /// render() does alone, whichever process each was made by: render() merges them so too.
    /// @throws InputError when the films differ in size
    void merge(const Rendering& next);

    /// Writes everything, exactly.
    /// @param picture  names what is rendered, as for Film::save
    void save(ByteWriter& to, std::string_view picture) const;

    /// Puts what was saved in the place of what is here.
    /// @throws InputError as Film::load does; everything then stays as it was
    void load(ByteReader& from, std::string_view picture);
};

}  // namespace caustic
