#pragma once

#include "math/color.h"
#include "math/hit.h"

namespace caustic {

/// A lit surface of that colour: a soft lamp from above left behind the eye, and its highlight.
Color litColor(const Hit& hit, const Vec3& wo, const Vec3& up, const Color& body);

}  // namespace caustic
