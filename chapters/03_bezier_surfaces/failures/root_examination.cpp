#include "failures/root_examination.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/parallel.h"
#include "failures/patch_cases.h"
#include "failures/patch_reference.h"
#include "revolution_cases.h"
#include "revolution_reference.h"
#include "surface/newton_revolution.h"

namespace caustic {

namespace {

constexpr std::int64_t raysPerBatch = 100;  // each batch goes to the next surface
constexpr Real tolerance = 1e-10;           // of the robust method's t, relative
constexpr Real newtonTolerance = 1e-6;      // of the others': what they are not faulted for

// A method by its name: t of the nearest meeting.
struct Method {
    std::string name;
    std::function<std::optional<Real>(const Ray&, Random&)> nearest;
};

// What a robust method says: all its roots, and how far off they are.
struct Root {
    Real t;
    Real cosine;    // between ray and normal
    Real distance;  // |L(t) - B|
};

bool contains(const ReferenceMeeting& meeting, Real t, Real slack) {
    return t >= meeting.tLow - slack && t <= meeting.tHigh + slack;
}

// Whether `t` is what brute force has as the nearest meeting; nothing when the band leaves it open.
std::optional<bool> isNearest(const std::vector<ReferenceMeeting>& reference, const std::optional<Real>& t,
                              Real slack) {
    for (const ReferenceMeeting& meeting : reference) {
        if (meeting.tHigh < -slack) continue;
        if (meeting.inBand || meeting.tLow <= slack) return std::nullopt;
        return t && contains(meeting, *t, slack);
    }
    return !t;
}

void judge(RootExamination& count, const Ray& ray, Real size, const std::vector<ReferenceMeeting>& reference,
           const std::vector<Root>& roots, const std::vector<Method>& methods, Random& random) {
    const Real lengths = 1 / ray.direction.norm();
    const Real reach = size + ray.origin.norm();
    const Real slack = tolerance * reach * lengths;
    ++count.rays;
    bool inBand = false;
    for (const ReferenceMeeting& meeting : reference) {
        ++count.meetings;
        inBand = inBand || meeting.inBand;
        const bool found =
            std::any_of(roots.begin(), roots.end(), [&](const Root& root) { return contains(meeting, root.t, slack); });
        count.misses += !meeting.inBand && !found ? 1 : 0;
    }
    count.raysInBand += inBand ? 1 : 0;
    std::optional<Real> nearest;
    for (const Root& root : roots) {
        const bool real = std::any_of(reference.begin(), reference.end(), [&](const ReferenceMeeting& meeting) {
            return contains(meeting, root.t, slack);
        });
        count.falseHits += !real && root.cosine >= tangencyBand ? 1 : 0;
        count.worstDistance = std::max(count.worstDistance, root.distance / reach);
        if (root.t > 0 && !(nearest && *nearest <= root.t)) nearest = root.t;
    }
    for (std::size_t i = 0; i <= methods.size(); ++i) {
        const bool robust = i == 0;
        const auto t = robust ? nearest : methods[i - 1].nearest(ray, random);
        const auto right = isNearest(reference, t, (robust ? tolerance : newtonTolerance) * reach * lengths);
        if (!right) continue;
        ++count.nearest[i].trials;
        count.nearest[i].failures += *right ? 0 : 1;
    }
}

RootExamination emptyCount(const std::vector<Method>& methods) {
    RootExamination count;
    count.nearest.push_back({"robust", 0, 0});
    for (const Method& method : methods) count.nearest.push_back({method.name, 0, 0});
    return count;
}

template <typename Batch>
RootExamination sumOfBatches(std::int64_t rays, int threads, const Batch& batch) {
    const std::int64_t batches = (rays + raysPerBatch - 1) / raysPerBatch;
    std::vector<RootExamination> counts(static_cast<std::size_t>(batches));
    parallelFor(batches, threads, [&](std::int64_t i) {
        counts[static_cast<std::size_t>(i)] = batch(i, std::min(raysPerBatch, rays - i * raysPerBatch));
    });
    RootExamination sum = counts.front();
    for (std::size_t i = 1; i < counts.size(); ++i) sum += counts[i];
    return sum;
}

std::vector<Method> revolutionMethods(const std::vector<BezierCurve>& profile) {
    const auto method = [&](const std::string& name, NewtonStartRule rule, int samples) {
        return Method{name, [newton = NewtonRevolution(profile, rule, samples)](const Ray& ray, Random& random) {
                          return newton.intersect(ray, random);
                      }};
    };
    return {method("random start", NewtonStartRule::Random, 1), method("4x4 starts", NewtonStartRule::Grid, 1),
            method("bracketing with 8 samples", NewtonStartRule::Bracketing, 8)};
}

std::vector<Root> allRoots(const SurfaceOfRevolution& surface, Ray ray) {
    std::vector<Root> roots;
    ray.tMin = -std::numeric_limits<Real>::max();
    const Vec3 direction = ray.direction.normalized();
    while (const auto hit = surface.intersect(ray)) {
        const Real along = hit->uv.x() * static_cast<Real>(surface.profile().size());
        const std::size_t segment = std::min(static_cast<std::size_t>(along), surface.profile().size() - 1);
        const Real u = along - static_cast<Real>(segment);
        roots.push_back({hit->t, std::abs(hit->ng.dot(direction)),
                         distanceFromRevolved(surface.profile()[segment], u, ray.at(hit->t))});
        ray.tMin = hit->t;
    }
    return roots;
}

std::vector<Method> patchMethods(const BezierPatch& patch) {
    const auto nearest = [](const ParametricPatch& surface, const Ray& ray, const NewtonStarts& starts) {
        const auto found = nearestByNewton(surface, ray, starts);
        return found ? std::optional<Real>(found->t) : std::nullopt;
    };
    const ParametricPatch surface(patch);
    return {
        {"random start",
         [=](const Ray& ray, Random& random) { return nearest(surface, ray, randomStarts(surface, ray, 1, random)); }},
        {"4x4 starts", [=](const Ray& ray, Random&) { return nearest(surface, ray, gridStarts(surface, ray)); }}};
}

std::vector<Root> allRoots(const PatchSurface& surface, const Ray& ray) {
    std::vector<Root> roots;
    const Vec3 direction = ray.direction.normalized();
    for (const PatchRoot& root : patchRoots(surface.patch(), ShearedRay(ray))) {
        roots.push_back({root.t, std::abs(surface.normal(root.u, root.v).dot(direction)),
                         distanceFromPatch(surface.patch(), root.u, root.v, ray.at(root.t))});
    }
    return roots;
}

}  // namespace

RootExamination& RootExamination::operator+=(const RootExamination& other) {
    rays += other.rays;
    meetings += other.meetings;
    misses += other.misses;
    falseHits += other.falseHits;
    raysInBand += other.raysInBand;
    worstDistance = std::max(worstDistance, other.worstDistance);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        nearest[i].failures += other.nearest[i].failures;
        nearest[i].trials += other.nearest[i].trials;
    }
    return *this;
}

std::vector<std::string> revolutionSetNames() {
    std::vector<std::string> names;
    for (const RaySet& set : revolutionRaySets()) names.push_back(set.name);
    return names;
}

std::vector<std::string> patchSetNames() {
    std::vector<std::string> names;
    for (const PatchRaySet& set : patchRaySets()) names.push_back(set.name);
    return names;
}

RootExamination examineRevolution(std::size_t set, std::int64_t rays, std::uint64_t seed, int threads) {
    const auto make = revolutionRaySets()[set].make;
    const auto profiles = difficultProfiles();
    return sumOfBatches(rays, threads, [&](std::int64_t batch, std::int64_t count) {
        const auto& profile = profiles[static_cast<std::size_t>(batch) % profiles.size()].profile;
        const SurfaceOfRevolution surface(profile);
        const auto methods = revolutionMethods(surface.profile());
        RootExamination sum = emptyCount(methods);
        for (std::int64_t i = 0; i < count; ++i) {
            Random random(seed, {set, static_cast<std::uint64_t>(batch), static_cast<std::uint64_t>(i)});
            const Ray ray = make(surface, random);
            judge(sum, ray, surface.bounds().diagonal().norm(), meetingsBySubdivision(surface.profile(), ray),
                  allRoots(surface, ray), methods, random);
        }
        return sum;
    });
}

RootExamination examinePatches(std::size_t set, std::int64_t rays, std::uint64_t seed, int threads) {
    const auto make = patchRaySets()[set].make;
    const auto patches = difficultPatches();
    return sumOfBatches(rays, threads, [&](std::int64_t batch, std::int64_t count) {
        const PatchSurface surface(patches[static_cast<std::size_t>(batch) % patches.size()]);
        const auto methods = patchMethods(surface.patch());
        RootExamination sum = emptyCount(methods);
        for (std::int64_t i = 0; i < count; ++i) {
            Random random(seed, {set, static_cast<std::uint64_t>(batch), static_cast<std::uint64_t>(i)});
            const Ray ray = make(surface, random);
            judge(sum, ray, surface.bounds().diagonal().norm(), meetingsBySubdivision(surface.patch(), ray),
                  allRoots(surface, ray), methods, random);
        }
        return sum;
    });
}

}  // namespace caustic
