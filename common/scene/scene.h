#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sampling/sampler.h"
#include "scene/interaction.h"
#include "scene/ray_counts.h"
#include "scene/scene_description.h"
#include "scene/scene_needs.h"

namespace caustic {

/// A piece of a ray's way that lies in one medium.
struct MediumSpan {
    Ray ray;                         ///< from where the piece begins, unit direction
    Real tEnd = 0;                   ///< where it ends; may be infinite
    const Medium* medium = nullptr;  ///< the medium
    MediumStack media;               ///< what the ray is in there
    Color before = Color::Ones();    ///< the share of light that passes the way up to the piece
};

/// Everything that light meets: shapes, materials, lights, media, camera. Never changes once it is made, so any number
/// of threads may use it.
class Scene {
public:
    /// An object's id is its place in the description's list; an instance within its shape may name another one.
    /// @throws InputError when an object has no shape, neither material nor interior nor emission, an index of
    /// refraction
    ///         that isn't positive, an emission whose shape can't be sampled; when a light is missing; when the ambient
    ///         light is negative
    explicit Scene(SceneDescription description);

    /// What it needs of a renderer.
    const SceneNeeds& needs() const { return needs_; }

    /// All lights, those of shining objects included.
    const std::vector<std::shared_ptr<const Light>>& lights() const { return lights_; }
    /// Radiance from everywhere that nothing shades.
    const Color& ambient() const { return description_.ambient; }

    /// A box around all that is bounded; empty when nothing is.
    const Bounds3& bounds() const { return bounds_; }

    /// Where the picture is taken from.
    /// @throws InputError when the scene has no camera
    const Camera& camera() const;
    /// What the camera stands in.
    const MediumStack& cameraMedia() const { return cameraMedia_; }

    /// The nearest hit of anything, hidden boundaries included.
    std::optional<Hit> intersect(const Ray& ray) const;

    /// Follows a ray to the next surface that does something to light: on the way it passes index-matched boundaries,
    /// and those that are hidden in an object of higher priority. Media let pass what they neither absorb nor scatter.
    /// @param ray            unit direction
    /// @param media          what it starts in; afterwards what the surface is reached in
    /// @param transmittance  set to the share of light that passes the way
    /// @param counts         what is done is added
    /// @return nothing when it leaves the scene
    std::optional<Interaction> follow(const Ray& ray, MediumStack& media, Color& transmittance,
                                      RayCounts& counts) const;

    /// The same, for whoever gathers light along the whole way: tells through which media it leads.
    /// @param spans  set to the pieces that lie in a medium which scatters, in their order
    std::optional<Interaction> follow(const Ray& ray, MediumStack& media, Color& transmittance,
                                      std::vector<MediumSpan>& spans, RayCounts& counts) const;

    /// Follows a ray to a path's next vertex: a surface as above, or before that a point at which a medium scatters
    /// light. Where nothing scatters it is the same, and takes no numbers.
    /// @param weight   set to what the path's throughput is multiplied by: DistanceSample::weight of every medium on
    /// the
    ///                 way
    /// @param numbers  the path's
    /// @param vertex   which vertex of the path is looked for, from 0
    std::optional<Interaction> follow(const Ray& ray, MediumStack& media, Color& weight, const PathNumbers& numbers,
                                      int vertex, RayCounts& counts) const;

    /// The share of light that passes a shadow ray. Surfaces that refract stop it: what comes through them straight on
    /// is not what would come.
    /// @param media  what it starts in
    Color transmittance(const Ray& shadow, const MediumStack& media, RayCounts& counts) const;

    /// Radiance that arrives along a ray which has left the scene, W/(m²·sr).
    Color Le(const Ray& escaped) const;

    /// The objects with an interior that a point is in.
    MediumStack mediaAt(const Vec3& point) const;

private:
    // Each piece of the way within a medium is told to pass(medium, ray, tEnd, media), which multiplies the weight and
    // answers where light is scattered, if it is.
    template <typename Pass>
    std::optional<Interaction> followBy(const Ray& ray, MediumStack& media, RayCounts& counts, const Pass& pass) const;
    const SceneObject& object(ObjectId id) const;
    bool passesStraight(const SceneObject& one, const Crossing& crossing) const;
    std::optional<Interaction> interaction(const Hit& hit, const Vec3& wo, const Crossing& crossing,
                                           RayCounts& counts) const;
    void addObject(const SceneObject& one);
    void noteNeeds();

    SceneDescription description_;
    SceneNeeds needs_;
    bool indexMatched_ = false;                         // some boundary lets light pass straight on
    std::shared_ptr<const Shape> world_;                // null for an empty scene
    std::vector<std::shared_ptr<const Light>> lights_;  // those of objects first
    std::vector<const Light*> lightOfObject_;           // null for none
    std::vector<const Light*> infiniteLights_;
    Bounds3 bounds_;
    std::vector<Bounds3> interiorBounds_;  // around each object with an interior
    MediumStack cameraMedia_;
};

}  // namespace caustic
