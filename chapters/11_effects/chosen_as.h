#pragma once

#include <memory>
#include <utility>

#include "light/light.h"

namespace caustic {

/// A light that is chosen among others as if it had another power. Lights are chosen by power, and that of a panorama
/// is all that enters the sphere around the scene, of which next to nothing comes to where the picture looks: a
/// spotlight beside it would hardly ever be chosen. What a light brings is divided by how likely it was chosen, so
/// the picture stays what it is, with less noise.
class ChosenAs final : public Light {
public:
    /// @param power  that it is chosen by, W
    ChosenAs(std::shared_ptr<Light> light, Real power) : light_(std::move(light)), power_(power) {}

    void prepare(const Bounds3& scene) override { light_->prepare(scene); }
    bool deltaPlace() const override { return light_->deltaPlace(); }
    bool infinite() const override { return light_->infinite(); }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override {
        return light_->sampleDirect(from, u);
    }
    Real pdfW(const Vec3& from, const SurfacePoint& on) const override { return light_->pdfW(from, on); }
    Real pdfW(const Vec3& from, const Vec3& wi) const override { return light_->pdfW(from, wi); }
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override {
        return light_->sampleEmission(uPlace, uDirection);
    }
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override {
        return light_->pdfEmission(at, direction);
    }
    Color Le(const SurfacePoint& on, const Vec3& wo) const override { return light_->Le(on, wo); }
    Color Le(const Ray& escaped) const override { return light_->Le(escaped); }
    Color power() const override { return Color::Constant(power_); }

private:
    std::shared_ptr<Light> light_;
    Real power_;
};

}  // namespace caustic
