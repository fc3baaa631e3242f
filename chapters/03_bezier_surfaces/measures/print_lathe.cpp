#include "measures/print_lathe.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "figure/timing.h"
#include "math/slabs.h"
#include "revolution_cases.h"

namespace caustic {

namespace {

// The picture's rays: from one point, through the middle of each pixel of a square.
const Vec3 eye(0, 2, -4.6);
const Vec3 forward(0, -0.22, 1);
const Vec3 right(0.56, 0, 0);
const Vec3 up(0, 0.56, 0);

std::vector<Ray> raysOf(int width) {
    std::vector<Ray> rays;
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            const Real across = (x + Real(0.5)) / width - Real(0.5);
            const Real upwards = Real(0.5) - (y + Real(0.5)) / width;
            rays.push_back({eye, forward + across * right + upwards * up});
        }
    }
    return rays;
}

nlohmann::ordered_json jsonOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

void printLathe(int width, std::ostream& out) {
    const SurfaceOfRevolution surface(plainVase());
    const std::vector<Ray> rays = raysOf(width);
    std::int64_t tests = 0;
    for (const Ray& ray : rays) tests += mayMeet(surface.bounds(), ray) ? 1 : 0;
    const double nanoseconds = medianNanoseconds({[&] {
                                                     Real sum = 0;
                                                     for (const Ray& ray : rays) {
                                                         const auto hit = surface.intersect(ray);
                                                         if (hit) sum += hit->t;
                                                     }
                                                     keep(sum);
                                                 }},
                                                 {5, 1e-3})[0];
    nlohmann::ordered_json json;
    for (const BezierCurve& segment : surface.profile()) {
        for (const Vec3& point : segment.controlPoints()) json["profile"].push_back({point.x(), point.y()});
    }
    json["eye"] = jsonOf(eye);
    json["forward"] = jsonOf(forward);
    json["right"] = jsonOf(right);
    json["up"] = jsonOf(up);
    json["rays"] = rays.size();
    json["tests"] = tests;
    json["nanosecondsPerRay"] = nanoseconds / static_cast<double>(rays.size());
    json["nanosecondsPerTest"] = nanoseconds / static_cast<double>(tests);
    for (const Ray& ray : rays) {
        const auto hit = surface.intersect(ray);
        json["heights"].push_back(hit ? nlohmann::ordered_json(hit->point.y()) : nlohmann::ordered_json());
    }
    out << json.dump() << '\n';
}

}  // namespace caustic
