#include "image/laplacian.h"

#include <algorithm>

namespace caustic {

Image laplacian(const Image& image) {
    const int right = image.width() - 1;
    const int bottom = image.height() - 1;
    Image result(image.width(), image.height());
    for (int y = 0; y <= bottom; ++y) {
        for (int x = 0; x <= right; ++x) {
            const Color horizontal = image.at(std::max(x - 1, 0), y) + image.at(std::min(x + 1, right), y);
            const Color vertical = image.at(x, std::max(y - 1, 0)) + image.at(x, std::min(y + 1, bottom));
            result.set(x, y, horizontal + vertical - 4 * image.at(x, y));
        }
    }
    return result;
}

}  // namespace caustic
