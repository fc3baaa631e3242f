#pragma once

#include "math/real.h"

/// What the charts measure against: other forms of the same physics, which share no code with what is judged.
namespace caustic {

/// Reflectances of the two polarisations.
struct Polarised {
    Real across = 0;  ///< of light that swings across the plane of incidence
    Real within = 0;  ///< of light that swings within it
    /// Of unpolarised light.
    Real mean() const { return (across + within) / 2; }
};

/// Of a dielectric, by Fresnel's own forms: sin²(o − i)/sin²(o + i) and tan²(o − i)/tan²(o + i) of both angles, in
/// extended precision.
/// @param eta  index on the other side over that on wo's side
Polarised referenceDielectric(Real cosO, Real eta);

/// Of a conductor, by complex arithmetic.
/// @param eta  real part of the relative index of refraction
/// @param k    its imaginary part
Real referenceConductor(Real cosO, Real eta, Real k);

/// Share of the light sent along wo that isotropic rough metal gives back after one reflection, by quadrature over the
/// slopes of facets.
Real referenceAlbedo(Real cosO, Real eta, Real k, Real alpha);

}  // namespace caustic
