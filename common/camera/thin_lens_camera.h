#pragma once

#include "camera/pinhole_camera.h"

namespace caustic {

/// A camera whose lens is a disc: sharp at one distance, blurred before and behind it, the more the larger the lens.
///
/// All rays of a film point meet at one point of the plane in focus, which lies `focus` ahead and faces the camera;
/// the one through the middle of the lens is the pinhole's. Any other plane shows a disc, the circle of confusion.
/// Source: Cook, Porter, Carpenter 1984, Distributed Ray Tracing, 4.4; Potmesil, Chakravarty 1981.
class ThinLensCamera final : public Camera {
public:
    /// @param position  of the lens's middle; it and the next parameters as for a PinholeCamera
    /// @param radius    of the lens, m; at least 0. With 0 it is the pinhole, bit for bit
    /// @param focus     distance of the plane in focus, along the view, m; greater than 0
    /// @throws InputError for values outside, or not finite, and as PinholeCamera does
    ThinLensCamera(const Vec3& position, const Vec3& target, const Vec3& up, Real fieldOfView, int width, int height,
                   Real radius, Real focus);

    int width() const override { return pinhole_.width(); }
    int height() const override { return pinhole_.height(); }
    bool hasLens() const override { return radius_ > 0; }
    Ray sampleRay(const Vec2& film, const Vec2& lens) const override;
    std::optional<ImportanceSample> sampleImportance(const Vec3& point, const Vec2& lens) const override;
    CameraPdf pdf(const Ray& ray) const override;

    /// Diameter of the disc that a point ahead of the camera becomes, in pixels: 2 r |z − f| / (z f) over the size of a
    /// pixel at distance 1.
    /// @param depth  z, its distance along the view, m; greater than 0
    Real circleOfConfusion(Real depth) const;

private:
    Vec3 lensOffset(const Vec2& lens) const;
    Vec3 throughFocus(const Vec3& offset, const Vec3& direction) const;

    PinholeCamera pinhole_;
    Vec3 position_;
    Vec3 right_;
    Vec3 up_;
    Vec3 forward_;
    Real pixelSize_;  // at distance 1
    Real radius_;
    Real focus_;
};

}  // namespace caustic
