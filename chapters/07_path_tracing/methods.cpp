#include "methods.h"

#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"

namespace caustic {

std::string nameOf(Method method) {
    switch (method) {
        case Method::Chance:
            return "path tracing by chance";
        case Method::Direct:
            return "path tracing with direct light";
        case Method::Mis:
            return "path tracing with MIS";
        case Method::Light:
            return "light tracing";
        case Method::Bidirectional:
            break;
    }
    return "bidirectional path tracing";
}

std::unique_ptr<Integrator> makeIntegrator(Method method, const Scene& scene, const Sampler& sampler,
                                           const PixelFilter& filter, int mostSegments) {
    const PathLimits limits = {.maxLength = mostSegments};
    const auto pathTracer = [&](Direct direct) {
        return std::make_unique<PathTracer>(scene, sampler, filter, PathTracerSettings{limits, direct});
    };
    switch (method) {
        case Method::Chance:
            return pathTracer(Direct::ByChance);
        case Method::Direct:
            return pathTracer(Direct::DirectLight);
        case Method::Mis:
            return pathTracer(Direct::Mis);
        case Method::Light:
            return std::make_unique<LightTracer>(scene, sampler, filter, limits);
        case Method::Bidirectional:
            break;
    }
    return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, limits);
}

}  // namespace caustic
