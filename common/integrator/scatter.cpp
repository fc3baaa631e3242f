#include "integrator/scatter.h"

#include "core/not_implemented.h"

namespace caustic {

std::optional<Scattering> scatter(const Interaction& at, TransportMode mode, const PathNumbers& numbers, int vertex) {
    //! [ex-07.1]
    const Vec2 u = numbers.pair(Dimension::vertex(vertex, VertexUse::Direction));
    const Real uLobe = numbers.number(Dimension::vertex(vertex, VertexUse::Lobe));
    const auto sample = at.sample(u, uLobe, mode);
    if (!sample) return std::nullopt;
    // A delta lobe's weight is integrated over its one direction already: it has no cosine any more.
    const Real cosine = sample->delta() ? 1 : at.cosine(sample->wi);
    // Veach 1997, eq. 10.7.
    return Scattering{*sample, sample->f * cosine / sample->pdfW};
    //! [ex-07.1]
}

}  // namespace caustic
