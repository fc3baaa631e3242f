#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/check.h"
#include "light/area_light.h"
#include "math/spawn.h"
#include "scene/named_shape.h"
#include "shape/shape_tree.h"
#include "texture/check_color.h"

namespace caustic {

namespace {

// Whether its surface lets light pass straight on.
bool indexMatched(const SceneObject& one) { return !one.material && !one.emission; }

const Bounds3 everywhere(Vec3::Constant(-std::numeric_limits<Real>::infinity()),
                         Vec3::Constant(std::numeric_limits<Real>::infinity()));

// Where a path is scattered in a medium on its way to a vertex, or that it passes.
// @param behind  media that it has passed on that way
DistanceSample sampleDistance(const Medium& medium, const Ray& ray, Real tEnd, const PathNumbers& numbers, int vertex,
                              std::uint64_t behind) {
    // The first medium takes the vertex's numbers. Those behind it need others: that light has passed the first one
    // says that its number was large.
    const PathNumbers own = behind == 0 ? numbers : numbers.branch(~behind);
    return medium.sampleDistance(ray, tEnd, own.number(Dimension::vertex(vertex, VertexUse::Distance)),
                                 own.number(Dimension::vertex(vertex, VertexUse::Channel)));
}

}  // namespace

Scene::Scene(SceneDescription description) : description_(std::move(description)) {
    checkNotNegative(description_.ambient, "ambient light");
    std::vector<std::shared_ptr<const Shape>> members;
    for (const SceneObject& one : description_.objects) {
        addObject(one);
        members.push_back(std::make_shared<NamedShape>(one.shape, static_cast<ObjectId>(members.size())));
        if (one.shape->bounded()) bounds_.extend(one.shape->bounds());
        if (one.interior) interiorBounds_.push_back(one.shape->bounded() ? one.shape->bounds() : everywhere);
    }
    if (!members.empty()) world_ = std::make_shared<ShapeTree>(std::move(members));
    for (const auto& light : description_.lights) {
        checkArgument(light != nullptr, "scene's light", "", "must exist");
        light->prepare(bounds_);
        lights_.push_back(light);
        if (light->infinite()) infiniteLights_.push_back(light.get());
    }
    noteNeeds();
    if (needs_.interiors && description_.camera)
        cameraMedia_ =
            mediaAt(camera().sampleRay({camera().width() / 2.0, camera().height() / 2.0}, {0.5, 0.5}).origin);
}

const Camera& Scene::camera() const {
    if (!description_.camera) throw InputError({"scene", 0}, "", "has no camera");
    return *description_.camera;
}

std::optional<Hit> Scene::intersect(const Ray& ray) const {
    if (!world_) return std::nullopt;
    return world_->intersect(ray);
}

template <typename Pass>
std::optional<Interaction> Scene::followBy(const Ray& ray, MediumStack& media, RayCounts& counts,
                                           const Pass& pass) const {
    Ray rest = ray;
    for (;;) {
        ++counts.rays;
        const std::optional<Hit> hit = intersect(rest);
        if (const Medium* const medium = media.medium()) {
            if (const std::optional<Real> t = pass(*medium, rest, hit ? hit->t : rest.tMax))
                return std::optional<Interaction>(std::in_place, rest.at(*t), -ray.direction, *medium->phase(), media);
        }
        if (!hit) return std::nullopt;
        const SceneObject& one = object(hit->object);
        if (!one.interior) return interaction(*hit, -ray.direction, {media, media}, counts);

        ++counts.crossings;
        const bool entering = ray.direction.dot(hit->ng) < 0;
        const Crossing crossing = crossBoundary(media, hit->object, *one.interior, entering);
        if (!passesStraight(one, crossing)) {
            media = crossing.before;
            return interaction(*hit, -ray.direction, crossing, counts);
        }
        media = crossing.after;
        rest = spawnRay(*hit, ray.direction);
    }
}

std::optional<Interaction> Scene::follow(const Ray& ray, MediumStack& media, Color& transmittance,
                                         RayCounts& counts) const {
    transmittance = Color::Ones();
    return followBy(ray, media, counts, [&](const Medium& medium, const Ray& rest, Real tEnd) -> std::optional<Real> {
        ++counts.transmittances;
        transmittance *= medium.transmittance(rest, tEnd);
        return std::nullopt;
    });
}

std::optional<Interaction> Scene::follow(const Ray& ray, MediumStack& media, Color& transmittance,
                                         std::vector<MediumSpan>& spans, RayCounts& counts) const {
    transmittance = Color::Ones();
    spans.clear();
    return followBy(ray, media, counts, [&](const Medium& medium, const Ray& rest, Real tEnd) -> std::optional<Real> {
        if (medium.phase() != nullptr) spans.push_back({rest, tEnd, &medium, media, transmittance});
        ++counts.transmittances;
        transmittance *= medium.transmittance(rest, tEnd);
        return std::nullopt;
    });
}

std::optional<Interaction> Scene::follow(const Ray& ray, MediumStack& media, Color& weight, const PathNumbers& numbers,
                                         int vertex, RayCounts& counts) const {
    weight = Color::Ones();
    std::uint64_t passed = 0;  // media that scatter
    return followBy(ray, media, counts, [&](const Medium& medium, const Ray& rest, Real tEnd) -> std::optional<Real> {
        if (medium.phase() == nullptr) {
            ++counts.transmittances;
            weight *= medium.transmittance(rest, tEnd);
            return std::nullopt;
        }
        ++counts.distanceSamples;
        const DistanceSample sample = sampleDistance(medium, rest, tEnd, numbers, vertex, passed++);
        weight *= sample.weight;
        return sample.scattered ? std::optional<Real>(sample.t) : std::nullopt;
    });
}

Color Scene::transmittance(const Ray& shadow, const MediumStack& media, RayCounts& counts) const {
    ++counts.shadowRays;
    if (!world_) return Color::Ones();
    // In empty space the first boundary stops light, unless it is index-matched.
    if (!indexMatched_ && media.current() == nullptr) return world_->occluded(shadow) ? Color::Zero() : Color::Ones();

    Color passed = Color::Ones();
    MediumStack here = media;
    Ray rest = shadow;
    for (;;) {
        const std::optional<Hit> hit = intersect(rest);
        if (const Medium* const medium = here.medium()) {
            ++counts.transmittances;
            passed *= medium->transmittance(rest, hit ? hit->t : rest.tMax);
        }
        if (!hit) return passed;
        const SceneObject& one = object(hit->object);
        if (!one.interior) return Color::Zero();
        ++counts.crossings;
        const Crossing crossing = crossBoundary(here, hit->object, *one.interior, rest.direction.dot(hit->ng) < 0);
        if (!passesStraight(one, crossing)) return Color::Zero();
        here = crossing.after;
        const Ray onwards = spawnRay(*hit, shadow.direction);
        // The far end stays where it was.
        rest =
            std::isfinite(shadow.tMax) ? Ray{onwards.origin, shadow.at(shadow.tMax) - onwards.origin, 0, 1} : onwards;
    }
}

Color Scene::Le(const Ray& escaped) const {
    Color sum = Color::Zero();
    for (const Light* const light : infiniteLights_) sum += light->Le(escaped);
    return sum;
}

MediumStack Scene::mediaAt(const Vec3& point) const {
    MediumStack media;
    const auto around = [&](const Bounds3& bounds) { return bounds.contains(point); };
    if (std::none_of(interiorBounds_.begin(), interiorBounds_.end(), around)) return media;
    std::map<ObjectId, int> entered;  // on the way outwards
    // Any direction would do; one that no axis-parallel face is parallel to meets fewer edges.
    Ray ray = {point, Vec3(0.35, 0.87, 0.34).normalized()};
    while (const std::optional<Hit> hit = intersect(ray)) {
        const SceneObject& one = object(hit->object);
        if (one.interior) {
            int& times = entered[hit->object];
            if (ray.direction.dot(hit->ng) < 0) {
                ++times;
            } else if (times > 0) {
                --times;
            } else {
                media.enter(hit->object, *one.interior);
            }
        }
        ray = spawnRay(*hit, ray.direction);
    }
    return media;
}

const SceneObject& Scene::object(ObjectId id) const { return description_.objects[static_cast<std::size_t>(id)]; }

// Whether light goes through the boundary as if it weren't there: hidden in an object of higher priority, or
// index-matched.
bool Scene::passesStraight(const SceneObject& one, const Crossing& crossing) const {
    return indexMatched(one) || (!crossing.counts() && !one.emission);
}

std::optional<Interaction> Scene::interaction(const Hit& hit, const Vec3& wo, const Crossing& crossing,
                                              RayCounts& counts) const {
    const SceneObject& one = object(hit.object);
    // Made where it will stay: it is large.
    std::optional<Interaction> at(std::in_place, hit, wo, lightOfObject_[static_cast<std::size_t>(hit.object)],
                                  crossing);
    if (!one.material) return at;
    if (one.material->textured()) ++counts.textureLookups;
    const Real here = crossing.before.ior();
    const Real beyond = crossing.after.ior();
    const bool above = wo.dot(hit.ng) >= 0;
    one.material->build(hit, ShadingFrame::at(hit, above ? here : beyond, above ? beyond : here), at->bsdf_);
    return at;
}

void Scene::addObject(const SceneObject& one) {
    checkArgument(one.shape != nullptr, "scene's object", "", "needs a shape");
    checkArgument(one.material || one.interior || one.emission, "scene's object", "",
                  "needs a material, an interior or an emission");
    if (one.interior) checkPositive(one.interior->ior, "index of refraction");
    lightOfObject_.push_back(nullptr);
    if (!one.emission) return;
    const auto light = std::make_shared<AreaLight>(one.shape, one.emission);
    lights_.push_back(light);
    lightOfObject_.back() = light.get();
}

void Scene::noteNeeds() {
    for (const SceneObject& one : description_.objects) {
        const LobeFlags lobes = one.material ? one.material->lobes() : LobeFlags::None;
        needs_.specular = needs_.specular || anyOf(lobes, LobeFlags::Delta);
        needs_.diffuse = needs_.diffuse || anyOf(lobes, LobeFlags::Diffuse);
        needs_.glossy = needs_.glossy || anyOf(lobes, LobeFlags::Glossy);
        needs_.interiors = needs_.interiors || one.interior.has_value();
        indexMatched_ = indexMatched_ || indexMatched(one);
        needs_.medium = needs_.medium || (one.interior && one.interior->medium);
        needs_.scattering =
            needs_.scattering || (one.interior && one.interior->medium && one.interior->medium->phase());
        needs_.areaLights = needs_.areaLights || one.emission;
        needs_.textures = needs_.textures || (one.material && one.material->textured()) ||
                          (one.emission && !one.emission->constant());
    }
    needs_.environment = !infiniteLights_.empty();
    needs_.ambient = (description_.ambient > 0).any();
    needs_.lens = description_.camera && description_.camera->hasLens();
}

}  // namespace caustic
