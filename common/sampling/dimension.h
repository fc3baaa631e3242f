#pragma once

namespace caustic {

/// What a vertex of a path takes random numbers for. The value is the place within the vertex's range of dimensions.
enum class VertexUse {
    LightChoice = 0,  ///< which light: one number
    LightPoint = 1,   ///< where on it: a pair
    Direction = 3,    ///< the BSDF's, or a phase function's: a pair
    Lobe = 5,         ///< which lobe of the BSDF: one number
    Roulette = 6,     ///< whether the path goes on: one number
    Distance = 7      ///< how far light goes in a medium: one number
};

/// Which of a path's numbers. One decision always uses the same dimension, so that samplers which spread the numbers of
/// a dimension evenly over all paths can do so.
struct Dimension {
    int index = 0;  ///< from 0

    /// Of a path from the eye: where on the film and where on the lens, a pair each.
    static constexpr Dimension film() { return {0}; }
    /// Where on the lens: a pair.
    static constexpr Dimension lens() { return {2}; }

    /// Of a path from a light: where on the light and into which direction, a pair each. Which light it starts at is
    /// the choice of vertex 0.
    static constexpr Dimension emissionPoint() { return {0}; }
    /// Into which direction light is emitted: a pair.
    static constexpr Dimension emissionDirection() { return {2}; }

    /// Of vertex `k` of the path, counted from 0.
    static constexpr Dimension vertex(int k, VertexUse use) { return {4 + 8 * k + static_cast<int>(use)}; }
};

}  // namespace caustic
