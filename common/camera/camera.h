#pragma once

#include <optional>

#include "math/color.h"
#include "math/ray.h"
#include "math/vector.h"

namespace caustic {

/// Result of Camera::sampleImportance: how a point is seen.
struct ImportanceSample {
    Vec2 film = Vec2::Zero();  ///< where on the film, in pixels
    Real We = 0;               ///< importance emitted towards the point for a pixel of unit area, 1/(m²·sr); for a
                               ///< pinhole 1/sr
    Vec3 wi = Vec3::UnitZ();   ///< unit direction from the point to the camera
    Real distance = 0;         ///< between them
    Real cosine = 0;           ///< at the lens, between the view's direction and −wi
    Real pdfA = 0;             ///< density of the lens point over area, 1/m²; 1 for a pinhole
    Vec3 lens = Vec3::Zero();  ///< the lens point
};

/// The two densities of a ray that leaves the camera.
struct CameraPdf {
    Real pdfA = 0;  ///< of the lens point, 1/m²; 0 for a pinhole: no other path finds it by chance
    Real pdfW = 0;  ///< of the direction when the film point is uniform over the film, 1/sr
};

/// Where a picture is taken from. The film is measured in pixels as an Image is: x to the right, y down, (0, 0) in its
/// upper left corner.
///
/// A pixel's value is I_j = ∫ h_j(x) L(x) dx over the film, with the pixel filter h_j of integral 1; so
/// I_j = ∫∫ h_j We L |cos| dA dω, with We per pixel of unit area.
class Camera {
public:
    virtual ~Camera() = default;

    /// Pixels of the film.
    virtual int width() const = 0;
    /// Rows of it.
    virtual int height() const = 0;

    /// Whether the lens has an extent, so that `lens` numbers mean something.
    virtual bool hasLens() const = 0;

    /// The ray of a film point, unit direction.
    /// @param film  in pixels; may lie outside, where pixel filters reach
    /// @param lens  two uniform numbers in [0, 1): which point of the lens
    virtual Ray sampleRay(const Vec2& film, const Vec2& lens) const = 0;

    /// How a point in space is seen through a point of the lens; nothing when it isn't on the film.
    virtual std::optional<ImportanceSample> sampleImportance(const Vec3& point, const Vec2& lens) const = 0;

    /// The densities of a ray from the lens; both 0 when its film point is outside.
    virtual CameraPdf pdf(const Ray& ray) const = 0;
};

}  // namespace caustic
