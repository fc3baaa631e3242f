#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "material/directions.h"
#include "math/frame.h"
#include "sampling/warp.h"
#include "support/in_cube.h"
#include "texture/mapped_normal.h"

namespace caustic {
namespace {

Vec3 direction(Random& random) {
    const Real x = random.uniform();
    return uniformSphere({x, random.uniform()});
}

// u and v skew and of any length, left-handed in half of the cases; ns a little off ng.
Hit someHit(Random& random, bool smooth) {
    Hit hit;
    hit.ng = direction(random);
    const Frame frame = Frame::around(hit.ng);
    const Real scale = std::pow(10, random.uniform(-3, 3));
    const Real angle = random.uniform(0, 6.28);
    hit.dpdu = scale * (std::cos(angle) * frame.s + std::sin(angle) * frame.t);
    const Real other = angle + (random.below(2) == 0 ? 1 : -1) * random.uniform(0.4, 2.7);
    hit.dpdv = 3 * scale * (std::cos(other) * frame.s + std::sin(other) * frame.t);
    hit.ns = smooth ? (hit.ng + 0.15 * direction(random)).normalized() : hit.ng;
    return hit;
}

Vec3 someLocal(Random& random) {
    const Real slope = random.uniform(0.01, 1);
    const Real angle = random.uniform(0, 6.28);
    return Vec3(slope * std::cos(angle), slope * std::sin(angle), 1).normalized();
}

// Seen from straight above nothing is bent: the parts along u, across it on v's side, and along ns are the map's.
TEST(MappedNormal, MapStandsOnUAndV) {
    Random random(11, {1});
    for (int i = 0; i < 1000; ++i) {
        const Hit hit = someHit(random, i % 3 == 0);
        Vec3 local = someLocal(random);
        local = Vec3(0.3 * local.x(), 0.3 * local.y(), 1).normalized();
        const Vec3 normal = mappedNormal(hit, local, hit.ng);
        ASSERT_NEAR(normal.norm(), 1, 1e-9);
        ASSERT_NEAR(normal.dot(hit.ns), local.z(), 1e-9) << "z goes along which normal?";
        const Vec3 u = (hit.dpdu - hit.dpdu.dot(hit.ns) * hit.ns).normalized();
        ASSERT_NEAR(normal.dot(u), local.x(), 1e-9) << "x goes along u, made perpendicular to ns and of unit length.";
        const Vec3 v = hit.dpdv - hit.dpdv.dot(hit.ns) * hit.ns;
        const Vec3 across = (v - v.dot(u) * u).normalized();
        ASSERT_NEAR(normal.dot(across), local.y(), 1e-9) << "Where u and v are left-handed, where does y go?";
    }
    // u of any length next to v's, and so near to ns that only a millionth of it lies along the surface.
    for (const Real size : {1e-9, 1.0, 1e9}) {
        for (const Real other : {1e-12, 1.0, 1e12}) {
            Hit hit = someHit(random, true);
            const Frame frame = Frame::around(hit.ns);
            hit.dpdu = size * (1e-6 * frame.s + hit.ns);
            hit.dpdv = size * other * frame.t;
            const Vec3 normal = mappedNormal(hit, Vec3(0.24, 0, 0.97).normalized(), hit.ng);
            ASSERT_NEAR(normal.dot(frame.s), Vec3(0.24, 0, 0.97).normalized().x(), 1e-6)
                << "u " << size << ", v " << size * other << " long: When has u no direction?";
        }
    }
}

// Whatever the map says and wherever wo is, on either side: the mirrored direction stays on wo's side of the surface,
// and so does the normal.
TEST(MappedNormal, NoReflectionGoesIntoTheSurface) {
    Random random(11, {2});
    for (int i = 0; i < 20'000; ++i) {
        const Hit hit = someHit(random, i % 2 == 0);
        const Real steep = std::pow(10, random.uniform(-4, 0));
        const Vec3 aside = hit.ng.cross(direction(random)).normalized();
        const Vec3 wo = ((i % 4 < 2 ? steep : -steep) * hit.ng + aside).normalized();
        const Vec3 normal = mappedNormal(hit, someLocal(random), wo);
        ASSERT_GT(normal.dot(hit.ng), 0) << "The normal has to stay on ng's side.";
        const Vec3 mirrored = reflected(wo, normal);
        ASSERT_GT(mirrored.dot(hit.ng) * wo.dot(hit.ng), 0)
            << "A mirror shows what is inside the surface there. By which angle may the normal differ from ng? And "
               "seen from below?";
    }
    // And it is the same one from either side of the surface along one line.
    Random sides(11, {7});
    for (int i = 0; i < 5000; ++i) {
        const Hit hit = someHit(sides, i % 2 == 0);
        const Vec3 local = someLocal(sides);
        const Vec3 wo = (std::pow(10, sides.uniform(-3, 1)) * hit.ng + hit.ng.cross(direction(sides))).normalized();
        ASSERT_LE((mappedNormal(hit, local, wo) - mappedNormal(hit, local, -wo)).norm(), 1e-9)
            << "What does the side of wo turn round?";
    }
}

// Only what needs it is bent, in the plane of both normals, and just as far as needed.
TEST(MappedNormal, BendsNoFurtherThanNeeded) {
    Random random(11, {3});
    int bent = 0;
    for (int i = 0; i < 5000; ++i) {
        const Hit hit = someHit(random, false);
        const Vec3 local = someLocal(random);
        const Vec3 plain = mappedNormal(hit, local, hit.ng);
        const Real steep = std::pow(10, random.uniform(-2, 0));
        const Vec3 wo = (steep * hit.ng + hit.ng.cross(direction(random)).normalized()).normalized();
        const Vec3 normal = mappedNormal(hit, local, wo);
        // The map's own normal, which isn't bent when seen from straight above, unless it is as steep as 45 degrees.
        if (plain.dot(hit.ng) < 0.75) continue;
        const Real cosine = reflected(wo, plain).dot(hit.ng);
        if (cosine > 0.011) {
            ASSERT_LT((normal - plain).norm(), 1e-9) << "A normal that is no trouble stays as it is.";
            continue;
        }
        if (cosine > 0) continue;
        ++bent;
        ASSERT_NEAR(reflected(wo, normal).dot(hit.ng), std::min(0.01, wo.dot(hit.ng) / 2), 1e-9)
            << "Is it turned further than it takes?";
        ASSERT_NEAR(normal.dot(hit.ng.cross(plain).normalized()), 0, 1e-9) << "In which plane is it turned?";
    }
    EXPECT_GT(bent, 300);
    // wo in the surface, and in no plane with the normal: nothing to reckon an angle from.
    Hit flat;
    const Vec3 grazing = mappedNormal(flat, Vec3(0.6, 0, 0.8), Vec3::UnitY());
    ASSERT_NEAR(grazing.norm(), 1, 1e-9) << "Is 0 divided by 0?";
    ASSERT_GT(grazing.z(), 0);
}

// A flat map leaves the normal as it was, to the last bit; and where u has no direction there is no map.
TEST(MappedNormal, FlatChangesNothing) {
    // Along the surface, across the plane in which a normal leans: bending it wouldn't change a thing.
    Hit level;
    level.ng = level.ns = Vec3::UnitZ();
    level.dpdu = Vec3::UnitX();
    level.dpdv = Vec3::UnitY();
    EXPECT_EQ(mappedNormal(level, Vec3(-0.6, 0, 0.8), Vec3::UnitY()), Vec3(-0.6, 0, 0.8));

    Random random(11, {4});
    for (int i = 0; i < 1000; ++i) {
        Hit hit = someHit(random, true);
        const Vec3 wo = direction(random);
        ASSERT_EQ(mappedNormal(hit, Vec3::UnitZ(), wo), hit.ns) << "Bit for bit: is it made anew?";
        hit.dpdu = Vec3::Zero();
        ASSERT_EQ(mappedNormal(hit, someLocal(random), wo), hit.ns) << "At a pole, is 0 divided by 0?";
        hit.dpdu = 700 * hit.ns;
        ASSERT_EQ(mappedNormal(hit, someLocal(random), wo), hit.ns) << "What rounding leaves of u is no direction.";
    }
}

}  // namespace
}  // namespace caustic
