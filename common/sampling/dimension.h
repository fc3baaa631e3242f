#pragma once

namespace caustic {

/// What a vertex of a path takes random numbers for. The value is the place within the vertex's range of dimensions;
/// 12 to 15 are free.
enum class VertexUse {
    LightChoice = 0,  ///< which light: one number
    LightPoint = 1,   ///< where on it: a pair
    Direction = 3,    ///< the BSDF's, or a phase function's: a pair
    Lobe = 5,         ///< which lobe of the BSDF: one number
    Roulette = 6,     ///< whether the path goes on: one number
    Distance = 7,     ///< how far light goes in a medium: one number
    Channel = 8,      ///< which colour the distance in a coloured medium is chosen for: one number
    Lens = 9,         ///< where on the lens a vertex is seen through: a pair
    Split = 11        ///< into how many parts a path goes on: one number
};

/// Which of a path's numbers. One decision always uses the same dimension, so that samplers which spread the numbers of
/// a dimension evenly over all paths can do so.
struct Dimension {
    int index = 0;  ///< from 0

    /// Of a path from the eye: where on the film, a pair.
    static constexpr Dimension film() { return {0}; }
    /// Where on the lens: a pair.
    static constexpr Dimension lens() { return {2}; }

    /// Of a path from a light: where on the light, a pair. Which light it starts at is the choice of vertex 0.
    static constexpr Dimension emissionPoint() { return {0}; }
    /// Into which direction light is emitted: a pair.
    static constexpr Dimension emissionDirection() { return {2}; }

    /// Of vertex `k` of the path, counted from 0.
    static constexpr Dimension vertex(int k, VertexUse use) { return {start + perVertex * k + static_cast<int>(use)}; }

private:
    static constexpr int start = 8;       // 4 to 7 are free: a moment while the shutter is open, a wavelength
    static constexpr int perVertex = 16;  // as later chapters ask for more, no number of an earlier one moves
};

}  // namespace caustic
