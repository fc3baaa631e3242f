#pragma once

namespace caustic {

/// A pixel of the film: column from the left, row from the top, both counted from 0.
struct Pixel {
    int x = 0;  ///< column
    int y = 0;  ///< row

    /// Equal in both.
    friend constexpr bool operator==(const Pixel&, const Pixel&) = default;
};

}  // namespace caustic
