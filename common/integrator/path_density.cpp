#include "integrator/path_density.h"

#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

namespace {

Real squared(Real x) { return x * x; }

}  // namespace

PathDensity PathDensity::next(const VertexPdf& left, const Segment& segment) const {
    //! [ex-07.7]
    // Veach 1997, 8.2.2: dω/dA turns densities over solid angle into densities over area, there and back.
    const Real pdfA = left.forward * segment.cosTo / segment.squaredDistance;
    const Real backToArea = segment.cosFrom / segment.squaredDistance;
    PathDensity there;
    // Georgiev 2012, eq. 34.
    there.dVCM = left.connectible ? 1 / squared(pdfA) : 0;
    // Georgiev 2012, eq. 35, and eq. 53 f. for a vertex that cannot be connected: no walk ends there.
    const Real here = left.connectible ? dVCM : 0;
    there.dVC = squared(backToArea / pdfA) * (here + squared(left.reverse) * dVC);
    return there;
    //! [ex-07.7]
}

Real PathDensity::others(Real reverse, Real reversePdfW) const {
    //! [ex-07.8]
    // Georgiev 2012, eq. 40.
    return squared(reverse) * (dVCM + squared(reversePdfW) * dVC);
    //! [ex-07.8]
}

}  // namespace caustic
