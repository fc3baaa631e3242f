#pragma once

#include "camera/camera.h"
#include "math/frame.h"

namespace caustic {

/// A camera whose lens is a point: everything is sharp.
class PinholeCamera final : public Camera {
public:
    /// @param position     of the pinhole
    /// @param target       what the middle of the film shows
    /// @param up           what is up in the picture; any length, not along the view
    /// @param fieldOfView  from the film's lower to its upper edge, radians, in (0, π)
    /// @param width        pixels in a row
    /// @param height       rows
    /// @throws InputError for values outside, not finite, or an absurd size (Image::mostPixels)
    PinholeCamera(const Vec3& position, const Vec3& target, const Vec3& up, Real fieldOfView, int width, int height);

    int width() const override { return width_; }
    int height() const override { return height_; }
    bool hasLens() const override { return false; }
    Ray sampleRay(const Vec2& film, const Vec2& lens) const override;
    std::optional<ImportanceSample> sampleImportance(const Vec3& point, const Vec2& lens) const override;
    CameraPdf pdf(const Ray& ray) const override;

private:
    Real pixelSize() const;
    std::optional<Vec2> filmPoint(const Vec3& direction) const;

    Vec3 position_;
    Vec3 right_;
    Vec3 up_;
    Vec3 forward_;
    Real halfHeight_;  // of the film at distance 1
    int width_;
    int height_;
};

}  // namespace caustic
