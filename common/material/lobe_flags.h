#pragma once

namespace caustic {

/// What a lobe of a BSDF does with light, as a set.
enum class LobeFlags : unsigned {
    None = 0,
    Reflection = 1,    ///< stays on the side of wo
    Transmission = 2,  ///< goes to the other side
    Diffuse = 4,       ///< into all directions alike
    Glossy = 8,        ///< around a direction
    Delta = 16         ///< into one direction only
};

/// Both sets together.
constexpr LobeFlags operator|(LobeFlags a, LobeFlags b) {
    return static_cast<LobeFlags>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// Whether the sets share a flag.
constexpr bool anyOf(LobeFlags set, LobeFlags flags) {
    return (static_cast<unsigned>(set) & static_cast<unsigned>(flags)) != 0;
}

}  // namespace caustic
