#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "light/light.h"

namespace caustic::test {

/// Another light as sampleDirect sees it, and a list of what it was asked: by one thread only. No path hits it or sets
/// out from it.
class RecordingLight final : public Light {
public:
    /// @param light  shines in its place
    explicit RecordingLight(std::shared_ptr<Light> light) : light_(std::move(light)) {}

    bool deltaPlace() const override { return light_->deltaPlace(); }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override {
        asked_.push_back(u);
        return light_->sampleDirect(from, u);
    }
    std::optional<EmissionSample> sampleEmission(const Vec2&, const Vec2&) const override { return std::nullopt; }
    EmissionPdf pdfEmission(const SurfacePoint&, const Vec3&) const override { return {}; }
    Color power() const override { return light_->power(); }

    /// The numbers that it was asked with since the last `forget`.
    const std::vector<Vec2>& asked() const { return asked_; }
    /// Begins a new list.
    void forget() const { asked_.clear(); }

private:
    std::shared_ptr<Light> light_;
    mutable std::vector<Vec2> asked_;
};

}  // namespace caustic::test
