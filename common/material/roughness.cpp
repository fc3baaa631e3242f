#include "material/roughness.h"

#include "core/check.h"
#include "material/ggx.h"

namespace caustic {

bool looksSmooth(Real alphaX, Real alphaY) { return alphaX < Ggx::smoothBelow && alphaY < Ggx::smoothBelow; }

void checkRoughness(Real alphaX, Real alphaY) {
    for (const Real alpha : {alphaX, alphaY})
        checkArgument(alpha >= 0 && alpha <= 1, "roughness", formatReal(alpha), "must be between 0 and 1");
}

}  // namespace caustic
