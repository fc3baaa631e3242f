#pragma once

#include "math/color.h"
#include "math/real.h"

namespace caustic {

/// Share of unpolarised light that a smooth boundary between two clear media reflects, in [0, 1]; 1 from the
/// critical angle on, and along the surface. The same from both sides: F(cosO, eta) = F(cosI, 1/eta), where cosI is
/// on the other side by Snell's law. Source: Fresnel 1823; PBR 9.3.
/// @param cosO  cosine between wo and the normal on wo's side, in [0, 1]
/// @param eta   index of refraction on the other side over the one on wo's side, greater than 0
Real fresnelDielectric(Real cosO, Real eta);

/// Schlick's formula for the same: R0 + (1 − R0)(1 − cos)⁵, where R0 = ((1 − eta)/(1 + eta))² is exact at normal
/// incidence and cos is the cosine on the side of the smaller index. Exact at the critical angle and beyond it, too.
/// Source: Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering.
/// @param cosO  cosine between wo and the normal on wo's side, in [0, 1]
/// @param eta   index of refraction on the other side over the one on wo's side, greater than 0
Real schlick(Real cosO, Real eta);

/// Schlick's formula for what is known by its reflectance at normal incidence alone, such as a metal's colour.
/// @param cosO  cosine between wo and the normal, in [0, 1]
/// @param r0    reflectance at normal incidence, in [0, 1]
Color schlick(Real cosO, const Color& r0);

/// Share of unpolarised light that a polished conductor reflects, in [0, 1]. With k = 0 it is fresnelDielectric.
/// Source: Born, Wolf, Principles of Optics, 14.2; PBR 9.3.
/// @param cosO  cosine between wo and the normal, in [0, 1]
/// @param eta   real part of the index of refraction over the index on wo's side, greater than 0, for each channel
/// @param k     imaginary part (extinction) over the same, at least 0
Color fresnelConductor(Real cosO, const Color& eta, const Color& k);

}  // namespace caustic
