#pragma once

#include <memory>
#include <string>
#include <vector>

#include "math/transform.h"
#include "shape/shape.h"

namespace caustic {

/// A shape with what a test needs to know of it.
struct CatalogueShape {
    std::string name;
    std::shared_ptr<const Shape> shape;
    bool closed;  ///< whether it has an inside
    bool convex;  ///< whether a ray that leaves it outwards never meets it again
};

/// One of everything: each shape of the library, stretched, turned and mirrored instances of them, a group.
///
/// @param place  applied to points and sizes: what the shapes are built from, not an Instance around them. Its linear
///               part must be a multiple of the identity.
std::vector<CatalogueShape> shapeCatalogue(const Transform& place = {});

/// A transform that spares nothing: it turns, stretches by 2, 1 and 1/2, shears and, if asked to, mirrors.
Transform unevenTransform(bool mirrored);

}  // namespace caustic
