#pragma once

#include <cstdint>
#include <string>

#include "material/ggx.h"
#include "material/metal.h"

namespace caustic {

/// Ways to pick where light comes from.
enum class DirectionChoice {
    VisibleNormals,  ///< mirror wo at a facet that it sees
    AllNormals,      ///< mirror wo at any facet
    Cosine           ///< in proportion to the cosine, whatever the facets
};

/// As the charts call it.
std::string nameOf(DirectionChoice choice);

/// The share of light that a rough metal gives back to a uniform surrounding, estimated. In the local frame.
class Furnace {
public:
    /// @param cosO  cosine of the direction that light leaves in, in (0, 1]
    Furnace(const Metal& metal, Real alphaX, Real alphaY, Real cosO);

    /// What one sample of the estimate is worth: f cosI / density. Green channel.
    Real weight(DirectionChoice choice, const Vec2& u) const;

    /// The mean of some samples, of a stream that is named by the round.
    Real estimate(DirectionChoice choice, int samples, std::uint64_t seed, std::uint64_t round) const;

private:
    Metal metal_;
    Ggx facets_;
    Vec3 wo_;
};

}  // namespace caustic
