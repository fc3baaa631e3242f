#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "methods.h"

namespace caustic {

/// How far off a method was after so much work.
struct ConvergencePoint {
    std::string scene;         ///< MeasuredScene::name
    Method method;             ///< which
    std::int64_t samples = 0;  ///< paths a pixel
    double seconds = 0;        ///< of one thread's computing time
    Real error = 0;            ///< RMSE against the scene's reference
};

/// Points of several methods in several scenes; of each in the order of their work.
using ConvergencePoints = std::vector<ConvergencePoint>;

/// The points of one method in one scene.
ConvergencePoints pointsOf(const ConvergencePoints& all, const std::string& scene, Method method);

/// The power of the number of samples with which the error goes: least squares of log error over log samples; −1/2
/// without bias. Needs two points.
Real slopeOf(const ConvergencePoints& points);

/// Error of one method over that of another after the same time, the longest that both have worked, interpolated
/// between logarithms.
Real errorRatio(const ConvergencePoints& all, const std::string& scene, Method one, Method other);

}  // namespace caustic
