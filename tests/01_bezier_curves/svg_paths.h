#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/text.h"
#include "curve/svg_path_data.h"

namespace caustic::test {

/// The splines of path data that has no mistake.
inline std::vector<BezierSpline> splinesOf(const std::string& data,
                                           const SvgTransform& transform = SvgTransform::Identity()) {
    return parseSvgPathData(data, transform, {"test.svg", 1});
}

/// Greatest distance between two lists of splines of the same shape, over all control points.
inline Real distanceBetween(const std::vector<BezierSpline>& a, const std::vector<BezierSpline>& b) {
    constexpr Real incomparable = 1e300;
    if (a.size() != b.size()) return incomparable;
    Real largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].segments().size() != b[i].segments().size() || a[i].closed() != b[i].closed()) return incomparable;
        for (std::size_t j = 0; j < a[i].segments().size(); ++j) {
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec3 difference = a[i].segments()[j].controlPoints()[k] - b[i].segments()[j].controlPoints()[k];
                largest = std::max(largest, difference.norm());
            }
        }
    }
    return largest;
}

/// Path data draws what other path data does.
inline void expectSamePath(const std::string& data, const std::string& meaning) {
    EXPECT_LE(distanceBetween(splinesOf(data), splinesOf(meaning)), 1e-12)
        << "'" << data << "' is not '" << meaning << "'";
}

/// A number as path data has it, and what separates it from the next one.
inline std::string number(Real value) { return formatReal(value) + " "; }

}  // namespace caustic::test
