#include "measures/reference_command.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "camera/box_filter.h"
#include "core/check.h"
#include "figures/equal_time.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "measures/caustic_reference.h"
#include "measures/measured_scenes.h"
#include "measures/work.h"
#include "methods.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr const char* causticOnFloor = "caustic_floor";
constexpr int causticWidth = 128;
constexpr std::int64_t photonsARound = 4'000'000;

// Sums pictures in double precision: thousands of them lose nothing.
class Mean {
public:
    void add(const Image& picture) {
        if (sums_.empty()) sums_.assign(picture.data().size(), 0);
        for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += Real(picture.data()[i]);
        ++count_;
    }
    Image image(int width, int height) const {
        Image mean(width, height);
        for (std::size_t i = 0; i < sums_.size(); ++i) mean.data()[i] = static_cast<float>(sums_[i] / count_);
        return mean;
    }

private:
    std::vector<Real> sums_;
    int count_ = 0;
};

Image average(const Image& one, const Image& other) {
    Mean mean;
    mean.add(one);
    mean.add(other);
    return mean.image(one.width(), one.height());
}

// Rounds of two halves each, until the time is over.
std::array<Image, 2> halves(const std::function<Image(std::uint64_t seed)>& round, double minutes) {
    const auto start = std::chrono::steady_clock::now();
    const auto spent = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 60;
    };
    std::array<Mean, 2> sums;
    int width = 0;
    int height = 0;
    std::uint64_t seed = 1'000'000;
    do {
        for (Mean& sum : sums) {
            const Image picture = round(seed++);
            width = picture.width();
            height = picture.height();
            sum.add(picture);
        }
    } while (spent() < minutes);
    std::printf("%llu rounds in %.1f minutes\n", static_cast<unsigned long long>(seed - 1'000'000), spent());
    return {sums[0].image(width, height), sums[1].image(width, height)};
}

}  // namespace

std::vector<std::string> referenceNames() {
    std::vector<std::string> names;
    for (const EqualTimePicture& one : equalTimePictures())
        names.push_back(std::filesystem::path(one.asset).stem().string());
    names.emplace_back(causticOnFloor);
    return names;
}

void makeReference(const std::string& picture, double minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options) {
    std::function<Image(std::uint64_t)> round;
    std::vector<bool> leftOut;
    if (picture == causticOnFloor) {
        round = [&](std::uint64_t seed) {
            return causticReference({}, causticWidth, photonsARound, options.threads, seed);
        };
    }
    for (const EqualTimePicture& one : equalTimePictures()) {
        if (!one.asset.ends_with("/" + picture + ".exr")) continue;
        const auto scene = std::make_shared<Scene>(one.make());
        leftOut = pixelsNearLamps(*scene, 2);
        round = [&options, scene, mostSegments = one.mostSegments](std::uint64_t seed) {
            const IndependentSampler sampler(seed);
            const BoxFilter filter;
            const auto tracer = makeIntegrator(Method::Bidirectional, *scene, sampler, filter, mostSegments);
            return render(*tracer, {.passes = 4, .threads = options.threads}).film.image();
        };
    }
    checkArgument(round != nullptr, "references", picture, "there is none of that name");
    const auto [first, second] = halves(round, minutes);
    saveImage(chapter.sourceDir / "assets/references" / (picture + ".exr"), average(first, second));
    std::printf("its own error, from the halves' difference: RMSE %.5f\n", rmse(first, second, leftOut) / 2);
}

}  // namespace caustic
