#include "image/picture_error.h"

#include <cmath>
#include <string>

#include "core/check.h"

namespace caustic {

Real rmse(const Image& picture, const Image& reference, const std::vector<bool>& leftOut) {
    const std::size_t pixels = picture.data().size() / 3;
    checkArgument(picture.width() == reference.width() && picture.height() == reference.height(), "picture",
                  std::to_string(picture.width()) + " x " + std::to_string(picture.height()),
                  "must have the size of its reference");
    checkArgument(leftOut.empty() || leftOut.size() == pixels, "pixels left out", std::to_string(leftOut.size()),
                  "must be none or all of the picture's");
    Real squares = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!leftOut.empty() && leftOut[i]) continue;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Real off = Real(picture.data()[3 * i + channel]) - Real(reference.data()[3 * i + channel]);
            squares += off * off;
        }
        ++counted;
    }
    checkArgument(counted > 0, "pixels left out", "", "must not be all of them");
    return std::sqrt(squares / static_cast<Real>(3 * counted));
}

}  // namespace caustic
