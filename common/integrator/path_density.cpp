#include "integrator/path_density.h"

#include "core/not_implemented.h"

namespace caustic {

namespace {

Real squared(Real x) { return x * x; }

}  // namespace

PathDensity PathDensity::next(const ScatteringPdf& pdf, const Segment& segment) const {
    //! [ex-07.7]
    PathDensity there;
    there.forward = pdf.onwards * segment.cosTo / segment.squaredDistance;
    there.toArea = segment.cosFrom / segment.squaredDistance;
    // No walk ends at a vertex that scatters into one direction only: neither this one here, nor the other one there.
    there.open = pdf.delta ? 0 : 1;
    const Real openHere = pdf.delta ? 0 : open;
    there.tail = (openHere + squared(pdf.back * toArea) * tail) / squared(forward);
    return there;
    //! [ex-07.7]
}

Real PathDensity::others(Real reverse, Real back) const {
    //! [ex-07.8]
    return squared(reverse / forward) * (open + squared(back * toArea) * tail);
    //! [ex-07.8]
}

}  // namespace caustic
