#include "measures/methods.h"

#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"

namespace caustic {

namespace {

// So close to 1 that a million passes change the radius by less than a ten-thousandth.
constexpr Real fixedRadius = 1 - 1e-5;

}  // namespace

std::string nameOf(Method method) {
    switch (method) {
        case Method::Path:
            return "path tracing";
        case Method::Bidirectional:
            return "bidirectional path tracing";
        case Method::PhotonMap:
            return "photon mapping";
        case Method::Pass:
            return "SPPM by pass ①";
        case Method::Point:
            break;
    }
    return "SPPM by point ②";
}

std::unique_ptr<Integrator> makeIntegrator(Method method, const Scene& scene, const Sampler& sampler,
                                           const PixelFilter& filter, const SppmSettings& settings) {
    SppmSettings own = settings;
    if (method == Method::Path)
        return std::make_unique<PathTracer>(scene, sampler, filter, PathTracerSettings{settings.limits, Direct::Mis});
    if (method == Method::Bidirectional)
        return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, settings.limits);
    if (method == Method::PhotonMap) own.alpha = fixedRadius;
    if (method == Method::Point) own.rule = RadiusRule::Point;
    return std::make_unique<Sppm>(scene, sampler, filter, own);
}

}  // namespace caustic
