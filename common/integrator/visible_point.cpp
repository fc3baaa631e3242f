#include "integrator/visible_point.h"

#include "core/not_implemented.h"

namespace caustic {

namespace {

// Goes on over delta lobes, and keeps where they end.
class SeenVisitor {
public:
    SeenVisitor(const Scene& scene, EyePath& path) : scene_(scene), path_(path) {}

    bool reached(const Interaction& at, const WalkState& state) {
        //! [ex-09.5]
        if (at.light() != nullptr) path_.seen += state.beta * at.Le();
        if (!at.connectible()) return true;
        path_.point = VisiblePoint{at, state.beta, state.length};
        return false;
        //! [ex-09.5]
    }

    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState& state) { path_.seen += state.beta * scene_.Le(state.ray); }

private:
    const Scene& scene_;
    EyePath& path_;
};

}  // namespace

EyePath findVisiblePoint(const Scene& scene, const Ray& ray, const MediumStack& media, const PathLimits& limits,
                         const PathNumbers& numbers, RayCounts& counts) {
    EyePath path;
    SeenVisitor visitor(scene, path);
    walk(scene, {ray, media, Color::Ones()}, TransportMode::Radiance, limits, numbers, counts, visitor);
    return path;
}

}  // namespace caustic
