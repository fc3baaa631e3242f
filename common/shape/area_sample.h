#pragma once

#include "math/surface_point.h"

namespace caustic {

/// Result of Shape::sampleArea.
struct AreaSample {
    SurfacePoint at;
    Real pdfA = 0;  ///< density over area, 1/m²; never zero
};

}  // namespace caustic
