#include "integrator/rendering.h"

#include <utility>

namespace caustic {

void Rendering::merge(const Rendering& next) {
    film.merge(next.film);
    counts += next.counts;
    passes += next.passes;
    seconds += next.seconds;
}

void Rendering::save(ByteWriter& to, std::string_view picture) const {
    film.save(to, picture);
    to.put(counts);
    to.put(passes);
    to.put(seconds);
    to.seal();
}

void Rendering::load(ByteReader& from, std::string_view picture) {
    Rendering saved = {Film(film.width(), film.height()), {}};
    saved.film.load(from, picture);
    saved.counts = from.get<RayCounts>();
    saved.passes = from.get<std::int64_t>();
    saved.seconds = from.get<double>();
    from.checkSeal();
    *this = std::move(saved);
}

}  // namespace caustic
