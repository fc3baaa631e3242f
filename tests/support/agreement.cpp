#include "support/agreement.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/parallel.h"
#include "image/color_space.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/phong_material.h"
#include "material/rough_conductor_material.h"
#include "mesh/triangle_mesh.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic::test {

namespace {

constexpr int blockSide = 16;
constexpr int blocksAlong = agreementSide / blockSide;
constexpr int blocks = blocksAlong * blocksAlong;
constexpr double familyRate = 1e-6;

// A ball of a few triangles that looks smooth: normals of the ball at its corners.
MeshData coarseBall(const Vec3& center, Real radius) {
    constexpr int around = 8;
    constexpr int rings = 5;
    MeshData mesh;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < around; ++i) {
            const Real theta = std::numbers::pi * j / rings;
            const Real phi = 2 * std::numbers::pi * i / around;
            const Vec3 normal(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            mesh.positions.push_back(center + radius * normal);
            mesh.normals.push_back(normal);
        }
    }
    const auto corner = [](int i, int j) { return static_cast<std::uint32_t>(j * around + i % around); };
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < around; ++i) {
            mesh.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
            mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
        }
    }
    mesh.normalCorners = mesh.triangles;
    return mesh;
}

SceneDescription boxWith(const std::vector<SceneObject>& objects, bool areaLamp) {
    SceneDescription scene = DiffuseBox{}.scene(agreementSide, agreementSide);
    if (!areaLamp) {
        std::erase_if(scene.objects, [](const SceneObject& one) { return one.emission != nullptr; });
        scene.lights = {std::make_shared<PointLight>(Vec3(0.1, -0.2, 0.7), Color(2, 1.8, 1.5))};
    }
    scene.objects.insert(scene.objects.end(), objects.begin(), objects.end());
    return scene;
}

SceneObject ball(const Vec3& center, Real radius, std::shared_ptr<const Material> material) {
    return {.shape = std::make_shared<Sphere>(center, radius), .material = std::move(material)};
}

// Leaves out what a path brings to its own pixel when the first surface that the eye meets has delta lobes only: the
// class L … S E, which is not among what splats.
class WithoutSpecularFirst final : public Integrator {
public:
    WithoutSpecularFirst(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                         std::unique_ptr<Integrator> inner)
        : Integrator(scene, sampler, filter), inner_(std::move(inner)) {}

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override {
        return specular(ray, media, counts) ? Color::Zero() : inner_->Li(ray, media, numbers, counts);
    }

    Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const override {
        const Color value = inner_->tracePath(path, splats, counts);
        const PathNumbers numbers = sampler().start(eyeStream, path.pixel, path.index);
        return specular(eyeRay(path, numbers, counts), scene().cameraMedia(), counts) ? Color::Zero() : value;
    }

private:
    bool specular(const Ray& ray, MediumStack media, RayCounts& counts) const {
        Color passed;
        const auto at = scene().follow(ray, media, passed, counts);
        return at && at->bsdf() != nullptr && !anyOf(at->bsdf()->lobes(), LobeFlags::Diffuse | LobeFlags::Glossy);
    }

    std::unique_ptr<Integrator> inner_;
};

class Brightened final : public Integrator {
public:
    Brightened(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, std::unique_ptr<Integrator> inner,
               Real factor)
        : Integrator(scene, sampler, filter), inner_(std::move(inner)), factor_(factor) {}

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override {
        return factor_ * inner_->Li(ray, media, numbers, counts);
    }

    Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const override {
        const std::size_t before = splats.size();
        const Color value = inner_->tracePath(path, splats, counts);
        for (std::size_t i = before; i < splats.size(); ++i) splats[i].value *= factor_;
        return factor_ * value;
    }

private:
    std::unique_ptr<Integrator> inner_;
    Real factor_;
};

// A mean and the square of its standard error.
struct Estimate {
    double mean = 0;
    double squaredError = 0;
};

Estimate estimateOf(const std::vector<double>& values) {
    Estimate all;
    const double count = static_cast<double>(values.size());
    for (const double value : values) all.mean += value / count;
    for (const double value : values)
        all.squaredError += (value - all.mean) * (value - all.mean) / (count * (count - 1));
    return all;
}

// Each block's luminance, and at the end the whole picture's, over independent batches.
struct Measured {
    std::vector<Estimate> estimates;
    std::int64_t bad = 0;
};

Measured measure(const Scene& scene, const MakeIntegrator& make, bool masked, int batches, std::int64_t samples,
                 std::uint64_t seed, int threads) {
    std::vector<std::vector<double>> values(blocks + 1, std::vector<double>(static_cast<std::size_t>(batches), 0));
    std::vector<std::int64_t> bad(static_cast<std::size_t>(batches), 0);
    parallelFor(batches, threads, [&](std::int64_t batch) {
        const IndependentSampler sampler(seed + static_cast<std::uint64_t>(batch));
        const BoxFilter filter;
        std::unique_ptr<Integrator> integrator = make(scene, sampler, filter);
        if (masked) integrator = std::make_unique<WithoutSpecularFirst>(scene, sampler, filter, std::move(integrator));
        const Film film = render(*integrator, {.passes = samples}).film;
        bad[static_cast<std::size_t>(batch)] = film.badSamples();
        for (int y = 0; y < agreementSide; ++y) {
            for (int x = 0; x < agreementSide; ++x) {
                const double share = luminance(film.value({x, y})) / (blockSide * blockSide);
                const auto block = static_cast<std::size_t>(y / blockSide * blocksAlong + x / blockSide);
                values[block][static_cast<std::size_t>(batch)] += share;
                values[blocks][static_cast<std::size_t>(batch)] += share / blocks;
            }
        }
    });
    Measured measured;
    for (const auto& block : values) measured.estimates.push_back(estimateOf(block));
    for (const std::int64_t count : bad) measured.bad += count;
    return measured;
}

double tOf(const Estimate& one, const Estimate& other) {
    const double squared = one.squaredError + other.squaredError;
    return squared > 0 ? (one.mean - other.mean) / std::sqrt(squared) : one.mean == other.mean ? 0 : 1e9;
}

}  // namespace

std::vector<AgreementScene> agreementScenes() {
    const auto white = std::make_shared<DiffuseMaterial>(Color::Constant(0.7));
    const auto shiny = std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(Color::Constant(0.4)),
                                                       Color::Constant(0.5), 20);
    const auto metal = std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.35, 0.35);
    SceneObject glossyFloor = {.shape = std::make_shared<Rectangle>(Vec3(-1, -1, -0.999), Vec3(2, 0, 0), Vec3(0, 2, 0)),
                               .material = shiny};
    return {
        {"diffuse box", boxWith({}, true)},
        {"smooth normals",
         boxWith({{.shape = std::make_shared<TriangleMesh>(coarseBall({0, 0.1, -0.5}, 0.45)), .material = white}},
                 true)},
        {"glass ball", boxWith({glassBall({0.1, 0, -0.5}, 0.4, 1.5)}, true), true},
        {"point lamp", boxWith({ball({-0.4, 0.2, -0.6}, 0.35, shiny), ball({0.4, -0.1, -0.65}, 0.3, white)}, false)},
        {"glossy", boxWith({ball({0.1, 0.1, -0.55}, 0.4, metal), glossyFloor}, true)}};
}

std::vector<AgreementMethod> agreementMethods() {
    static const PathLimits limits = {.maxLength = agreementSegments, .rouletteStart = 3};
    return {{"path tracing",
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                 return std::make_unique<PathTracer>(scene, sampler, filter, PathTracerSettings{limits, Direct::Mis});
             }},
            {"light tracing",
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                 return std::make_unique<LightTracer>(scene, sampler, filter, limits);
             },
             false},
            {"bidirectional", [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                 return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, limits);
             }}};
}

AgreementMethod brightened(const AgreementMethod& method, Real share) {
    return {method.name + ", brighter",
            [make = method.make, share](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                return std::make_unique<Brightened>(scene, sampler, filter, make(scene, sampler, filter), 1 + share);
            },
            method.sees};
}

Agreement compareMethods(const std::vector<AgreementScene>& scenes, const std::vector<AgreementMethod>& methods,
                         int batches, std::int64_t samples, int threads) {
    Agreement all;
    std::uint64_t seed = 1;
    const auto note = [&](double t, double& largest, const std::string& where) {
        if (std::abs(t) > largest) {
            largest = std::abs(t);
            all.worst = where;
        }
    };
    for (const AgreementScene& description : scenes) {
        const Scene scene(description.description);
        for (std::size_t i = 0; i < methods.size(); ++i) {
            for (std::size_t j = i + 1; j < methods.size(); ++j) {
                const bool masked = description.eyeMeetsSpecular && !(methods[i].sees && methods[j].sees);
                const auto estimates = [&](const AgreementMethod& method) {
                    const std::uint64_t own = seed;
                    seed += static_cast<std::uint64_t>(batches);
                    const Measured measured = measure(scene, method.make, masked, batches, samples, own, threads);
                    all.samples += batches * samples * agreementSide * agreementSide;
                    all.badSamples += measured.bad;
                    return measured.estimates;
                };
                const std::vector<Estimate> one = estimates(methods[i]);
                const std::vector<Estimate> other = estimates(methods[j]);
                const std::string where = description.name + ": " + methods[i].name + " and " + methods[j].name;
                for (std::size_t block = 0; block < blocks; ++block) {
                    const double t = tOf(one[block], other[block]);
                    note(t, all.largestT, where + ", block " + std::to_string(block));
                    all.variance += t * t;
                    ++all.comparisons;
                }
                note(tOf(one[blocks], other[blocks]), all.largestMeanT, where + ", whole picture");
                for (const Estimate& mean : {one[blocks], other[blocks]})
                    all.largestError = std::max(all.largestError, std::sqrt(mean.squaredError) / mean.mean);
            }
        }
    }
    // Welch's t has at least as many degrees of freedom as the smaller of the two has, and at most both together.
    const double freedom = 2.0 * (batches - 1);
    all.variance /= all.comparisons;
    all.expectedVariance = freedom / (freedom - 2);
    all.varianceBand = 4 * std::sqrt(2.0 / all.comparisons);
    const boost::math::students_t fewest(batches - 1);
    all.mostT = quantile(complement(fewest, familyRate / (2 * all.comparisons)));
    return all;
}

}  // namespace caustic::test
