#include "shape_catalogue.h"

#include "shape/box.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"

namespace caustic {

namespace {

using ShapePointer = std::shared_ptr<const Shape>;

// Ring cylinders stand on the y axis, so only an instance can take one elsewhere.
ShapePointer placedRing(const Transform& place, Real inner, Real outer, Real bottom, Real top) {
    const Real size = place.linear()(0, 0);
    const auto ring = std::make_shared<RingCylinder>(size * inner, size * outer, size * bottom, size * top);
    if (place.translation().isZero()) return ring;
    return std::make_shared<Instance>(ring, Transform::translation(place.translation()));
}

// The shape as if `transform` had been applied to it before it was put in its place.
ShapePointer uneven(const ShapePointer& shape, const Transform& place, bool mirrored) {
    return std::make_shared<Instance>(shape, place * unevenTransform(mirrored) * place.inverse());
}

ShapePointer pile(const Transform& place) {
    const Real size = place.linear()(0, 0);
    const auto box = std::make_shared<Box>(place.point({-1, -1, -1}), place.point({1, -0.5, 1}));
    const auto sphere = std::make_shared<Sphere>(place.point({0.3, 0, 0}), size / 2);
    const auto triangle = std::make_shared<Triangle>(place.point({-1, -0.4, -1}), place.point({-0.4, -0.4, 0.5}),
                                                     place.point({-0.8, 1, 0}));
    return std::make_shared<Group>(std::vector<ShapePointer>{box, sphere, triangle});
}

}  // namespace

Transform unevenTransform(bool mirrored) {
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = 0.3;
    const Vec3 factors(mirrored ? -2 : 2, 1, 0.5);
    return Transform::rotation({1, 2, -1}, 0.8) * Transform::scaling(factors) * Transform(shear, Vec3::Zero()) *
           Transform::rotation({0, 1, 3}, 2);
}

std::vector<CatalogueShape> shapeCatalogue(const Transform& place) {
    const auto at = [&](Real x, Real y, Real z) { return place.point({x, y, z}); };
    const Real size = place.linear()(0, 0);
    const auto box = std::make_shared<Box>(at(-1, -0.5, -0.8), at(0.9, 0.7, 0.6));
    const auto sphere = std::make_shared<Sphere>(at(0.1, -0.1, 0.2), 0.9 * size);
    const auto plane = std::make_shared<Plane>(at(0.2, 0.1, -0.3), Vec3(1, 2, -3));
    const auto triangle = std::make_shared<Triangle>(at(-1, -0.9, 0.1), at(1, -0.6, -0.4), at(0.2, 0.9, 0.5));
    const auto sliver = std::make_shared<Triangle>(at(-1, -0.9, 0.1), at(1, 0.7, -0.4), at(0.2, 0.0601, -0.2));
    const auto ring = placedRing(place, 0.5, 1, -0.6, 0.6);
    const auto cylinder = placedRing(place, 0, 0.8, -0.7, 0.5);
    const auto turned = uneven(uneven(sphere, place, false), place, true);
    return {
        {"box", box, true, true},
        {"sphere", sphere, true, true},
        {"plane", plane, false, true},
        {"triangle", triangle, false, true},
        {"sliver", sliver, false, true},
        {"ring cylinder", ring, true, false},
        {"cylinder", cylinder, true, true},
        {"uneven box", uneven(box, place, false), true, true},
        {"uneven sphere", uneven(sphere, place, false), true, true},
        {"uneven plane", uneven(plane, place, false), false, true},
        {"mirrored triangle", uneven(triangle, place, true), false, true},
        {"mirrored ring cylinder", uneven(ring, place, true), true, false},
        {"instance of an instance", turned, true, true},
        {"group", pile(place), false, false},
    };
}

}  // namespace caustic
