#pragma once

#include <vector>

#include "math/color.h"

namespace caustic {

/// A picture in linear RGB.
class Image {
public:
    Image(int width, int height);

private:
    int width_;
    int height_;
};

}  // namespace caustic
