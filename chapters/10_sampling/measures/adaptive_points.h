#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "integrator/adaptive.h"
#include "scenes.h"

namespace caustic {

/// A number and its standard error.
struct Measurement {
    Real value = 0;
    Real error = 0;
};

/// What pictures of the same kind, of different seeds, are like.
struct PictureNoise {
    Measurement variance;  ///< of a pixel's channel, mean over the picture
    Measurement worst;     ///< the same among the noisiest pixels of the uniform picture
    Measurement mean;      ///< of the picture
    double seconds = 0;    ///< of one thread, a picture
    Real paths = 0;        ///< a pixel
};

/// How a picture is taken, uniform without a rule.
struct Taking {
    std::string method;                                                          ///< as charts call it
    std::function<std::unique_ptr<AdaptiveRule>(const Scene& scene)> rule = {};  ///< none for uniform
    AdaptiveSettings settings = {};
    std::int64_t passes = 0;  ///< of a uniform one
};

/// Takes pictures of several seeds by each way. The first of the ways says which pixels are the noisiest.
/// @param width  of the picture, pixels
/// @param seeds  at least 3
std::vector<PictureNoise> noiseOf(const Study& study, int width, const std::vector<Taking>& ways, int seeds,
                                  FigureContext& context);

/// The ways that are compared, each with so many paths a pixel: uniform first, then the rules.
/// @param all  hash and edges, too
std::vector<Taking> waysToTake(std::int64_t paths, bool all);

/// One over the other.
Measurement ratio(const Measurement& one, const Measurement& other);

/// A way in a scene, beside uniform sampling.
struct AdaptivePoint {
    std::string scene;
    std::string method;
    std::int64_t paths = 0;  ///< a pixel
    PictureNoise noise;
    Measurement samplesGain;  ///< uniform variance over this one, with as many paths
    Measurement timeGain;     ///< the same in the same time: uniform variance goes with one over it
    Measurement worstGain;    ///< with as many paths, among the noisiest pixels
    Measurement bias;         ///< of the picture's mean, as a share of the uniform one's
};

/// All ways in all scenes.
std::vector<AdaptivePoint> adaptivePoints(FigureContext& context);

}  // namespace caustic
