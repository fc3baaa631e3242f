#include "material/metal.h"

#include "core/check.h"
#include "texture/check_color.h"

namespace caustic {

Metal Metal::gold() { return {{0.21, 0.43, 1.38}, {3.272, 2.455, 1.914}}; }

Metal Metal::silver() { return {{0.06, 0.06, 0.04}, {4.152, 3.586, 2.657}}; }

Metal Metal::copper() { return {{0.30, 1.02, 1.24}, {3.205, 2.577, 2.397}}; }

void checkMetal(const Metal& metal) {
    for (int channel = 0; channel < 3; ++channel) checkPositive(metal.eta[channel], "metal's index of refraction");
    checkNotNegative(metal.k, "metal's extinction");
}

}  // namespace caustic
