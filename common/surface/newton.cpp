#include "surface/newton.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

std::optional<NewtonPoint> newtonMeeting(const ParametricSurface& surface, const Ray& ray, const NewtonPoint& start,
                                         const NewtonLimits& limits) {
    //! [ex-03.4]
    const auto strays = [](Real parameter, Real by) { return !(parameter >= -by && parameter <= 1 + by); };
    const bool boundV = !surface.closedInV();
    NewtonPoint at = start;
    for (int i = 0; i <= limits.iterations; ++i) {
        const auto [point, du, dv] = surface.evaluate(at.u, at.v);
        const Vec3 apart = point - ray.at(at.t);
        if (apart.norm() <= limits.tolerance) {
            if (strays(at.u, 0) || (boundV && strays(at.v, 0))) return std::nullopt;
            return at;
        }
        // Cramer's rule for dt d - du Bu - dv Bv = B - L.
        const Vec3 normal = du.cross(dv);
        const Real determinant = ray.direction.dot(normal);
        const Vec3 across = apart.cross(ray.direction);
        at.t += apart.dot(normal) / determinant;
        at.u += across.dot(dv) / determinant;
        at.v -= across.dot(du) / determinant;
        if (strays(at.u, limits.stray) || (boundV && strays(at.v, limits.stray)) || !(at.t >= 0)) return std::nullopt;
    }
    return std::nullopt;
    //! [ex-03.4]
}

NewtonPoint startAt(const ParametricSurface& surface, const Ray& ray, Real u, Real v) {
    const Vec3 from = surface.evaluate(u, v).point - ray.origin;
    return {from.dot(ray.direction) / ray.direction.squaredNorm(), u, v};
}

NewtonStarts randomStarts(const ParametricSurface& surface, const Ray& ray, int count, Random& random) {
    NewtonStarts starts;
    for (int i = 0; i < count; ++i) {
        const Real u = random.uniform();
        starts.add(startAt(surface, ray, u, random.uniform()));
    }
    return starts;
}

NewtonStarts gridStarts(const ParametricSurface& surface, const Ray& ray) {
    constexpr int cells = 4;
    NewtonStarts starts;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            starts.add(startAt(surface, ray, (i + Real(0.5)) / cells, (j + Real(0.5)) / cells));
        }
    }
    return starts;
}

std::optional<NewtonPoint> nearestByNewton(const ParametricSurface& surface, const Ray& ray, const NewtonStarts& starts,
                                           const NewtonLimits& limits) {
    std::optional<NewtonPoint> nearest;
    for (std::size_t i = 0; i < starts.count; ++i) {
        const auto found = newtonMeeting(surface, ray, starts.start[i], limits);
        if (found && ray.reaches(found->t) && !(nearest && nearest->t <= found->t)) nearest = found;
    }
    return nearest;
}

}  // namespace caustic
