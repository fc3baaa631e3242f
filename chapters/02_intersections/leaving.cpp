#include "leaving.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "math/frame.h"
#include "math/spawn.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

bool isWrong(const std::optional<Hit>& next, const Vec3& direction, bool outwards, bool closed, bool convex) {
    if (outwards || !closed) return next && (convex || !closed || next->ng.dot(direction) > 0);
    return !next || next->ng.dot(direction) < 0;
}

// The upper partner of a contact: its lowest point or face is at y = 0, above the origin.
std::shared_ptr<const Shape> upperPartner(std::uint64_t which) {
    const auto box = std::make_shared<Box>(Vec3(-0.5, 0, -0.5), Vec3(0.5, 1, 0.5));
    if (which == 0) return std::make_shared<Sphere>(Vec3(0, 0.5, 0), 0.5);
    if (which == 1) return box;
    if (which == 2) return std::make_shared<RingCylinder>(0, 0.5, 0, 1);
    return std::make_shared<Instance>(box, Transform::rotation(Vec3::UnitY(), 0.6));
}

}  // namespace

LeavingRule relativeRule() { return spawnRay; }

LeavingRule fixedRule(Real distance) {
    return [distance](const Hit& from, const Vec3& direction) {
        const Real side = direction.dot(from.ng) >= 0 ? 1 : -1;
        return Ray{from.point + side * distance * from.ng, direction};
    };
}

FailureCount& FailureCount::operator+=(const FailureCount& other) {
    failures += other.failures;
    trials += other.trials;
    return *this;
}

FailureCount countSelfHits(const Shape& shape, bool closed, bool convex, const LeavingRule& rule, const Vec3& center,
                           Real reach, std::int64_t rays, std::uint64_t seed) {
    FailureCount count;
    for (std::uint64_t i = 0; count.trials < rays; ++i) {
        Random random(seed, {i});
        const Vec3 origin = center + 3 * reach * randomDirection(random);
        const auto sample = shape.sampleArea({random.uniform(), random.uniform()});
        const Vec3 target = sample ? sample->at.point : Vec3(center + reach * randomInBall(random));
        const std::optional<Hit> hit = shape.intersect({origin, target - origin});
        if (!hit) continue;
        const bool outwards = random.below(2) == 0;
        const Vec3 direction = directionBeside(hit->ng, outwards, random);
        ++count.trials;
        if (isWrong(shape.intersect(rule(*hit, direction)), direction, outwards, closed, convex)) ++count.failures;
    }
    return count;
}

FailureCount countLostContacts(const Transform& place, Real gap, const LeavingRule& rule, std::int64_t rays,
                               std::uint64_t seed) {
    const auto floor = std::make_shared<Box>(Vec3(-2, -1, -2), Vec3(2, 0, 2));
    const Instance lower(floor, place);
    std::array<std::shared_ptr<const Shape>, 4> uppers;
    for (std::size_t i = 0; i < uppers.size(); ++i) {
        const Transform lift = Transform::translation({0, gap, 0});
        uppers[i] = std::make_shared<Instance>(std::make_shared<Instance>(upperPartner(i), lift), place);
    }
    FailureCount count;
    for (; count.trials < rays; ++count.trials) {
        Random random(seed, {static_cast<std::uint64_t>(count.trials)});
        const Shape& upper = *uppers[random.below(uppers.size())];
        const bool upwards = random.below(2) == 0;
        // Down from within the gap onto the floor's top, or up to the upper one's lowest part.
        const Vec3 between = Vec3(random.uniform(-0.01, 0.01), gap / 2, random.uniform(-0.01, 0.01));
        const Vec3 y = upwards ? Vec3(-Vec3::UnitY()) : Vec3(Vec3::UnitY());
        const Shape& left = upwards ? lower : upper;
        const Shape& met = upwards ? upper : lower;
        const std::optional<Hit> from = left.intersect({place.point(between), place.vector(y)});
        const Vec3 across = Vec3(random.uniform(-1, 1), upwards ? 1 : -1, random.uniform(-1, 1));
        const std::optional<Hit> contact = from ? met.intersect(rule(*from, across)) : std::nullopt;
        if (!contact || contact->ng.dot(across) > 0) ++count.failures;  // missed, or met from the inside: jumped over
    }
    return count;
}

FailureCount countLostFarSides(const Transform& place, Real thickness, const LeavingRule& rule, std::int64_t rays,
                               std::uint64_t seed) {
    const Instance plate(std::make_shared<Box>(Vec3(-1, 0, -1), Vec3(1, thickness, 1)), place);
    FailureCount count;
    for (; count.trials < rays; ++count.trials) {
        Random random(seed, {static_cast<std::uint64_t>(count.trials)});
        const Vec3 above(random.uniform(-0.5, 0.5), 1, random.uniform(-0.5, 0.5));
        const Vec3 direction(random.uniform(-1, 1), -1, random.uniform(-1, 1));
        const auto from = plate.intersect({place.point(above), place.vector(Vec3(0, -1, 0))});
        if (!from) {
            ++count.failures;
            continue;
        }
        const auto farSide = plate.intersect(rule(*from, direction));
        const bool found = farSide && farSide->ng.y() < 0 && farSide->ng.dot(direction) > 0;
        if (!found) ++count.failures;
    }
    return count;
}

Vec3 directionBeside(const Vec3& n, bool outwards, Random& random) {
    const Frame frame = Frame::around(outwards ? n : Vec3(-n));
    const Real angle = 2 * std::numbers::pi * random.uniform();
    const Real cosine = random.below(2) == 0 ? random.uniform(1e-8, 1) : std::pow(10, random.uniform(-8, 0));
    const Real sine = std::sqrt(1 - cosine * cosine);
    return frame.toWorld({sine * std::cos(angle), sine * std::sin(angle), cosine});
}

Vec3 randomDirection(Random& random) {
    const Real z = random.uniform(-1, 1);
    const Real angle = 2 * std::numbers::pi * random.uniform();
    const Real s = std::sqrt(1 - z * z);
    return {s * std::cos(angle), s * std::sin(angle), z};
}

Vec3 randomInBall(Random& random) { return std::cbrt(random.uniform()) * randomDirection(random); }

}  // namespace caustic
