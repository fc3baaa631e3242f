#include "measures/reference_command.h"

#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdio>

#include "camera/box_filter.h"
#include "core/check.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "sampling/sobol_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

// To 12 bits of the fraction, so that the file packs well: no pixel moves by more than 1/8192 of itself.
float rounded(float value) {
    constexpr std::uint32_t dropped = 11;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value) + (1U << (dropped - 1));
    return std::bit_cast<float>(bits >> dropped << dropped);
}

Image mean(const Image& one, const Image& other) {
    Image both(one.width(), one.height());
    for (std::size_t i = 0; i < both.data().size(); ++i)
        both.data()[i] = rounded((one.data()[i] + other.data()[i]) / 2);
    return both;
}

}  // namespace

void makeReference(const std::string& name, double minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options) {
    checkPositive(minutes, "--minutes");
    checkArgument(name == "peers_box" || name == "point_box", "--reference", name, "must be peers_box or point_box");
    const NamedScene& named = namedScene(name);
    const Scene scene(named.make(named.width, named.height, ""));
    const BoxFilter filter;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(minutes * 60);
    const SobolSampler numbers[2] = {SobolSampler(1'000'001), SobolSampler(1'000'002)};
    Sppm halves[2] = {Sppm(scene, numbers[0], filter, named.settings), Sppm(scene, numbers[1], filter, named.settings)};
    const Film empty(named.width, named.height);
    Rendering renderings[2] = {{empty, {}}, {empty, {}}};
    std::int64_t passes = 0;
    do {
        ++passes;
        for (int i = 0; i < 2; ++i) resume(halves[i], {.passes = passes, .threads = options.threads}, renderings[i]);
    } while (std::chrono::steady_clock::now() < end);
    const Image first = renderings[0].film.image();
    const Image second = renderings[1].film.image();
    saveImage(chapter.sourceDir / "assets/references" / (name + "_sppm.exr"), mean(first, second));
    std::printf("%s: 2 times %lld passes; its own error, from the halves' difference: RMSE %.5f\n", name.c_str(),
                static_cast<long long>(passes), rmse(first, second, pixelsNearLamps(scene, 2)) / 2);
}

}  // namespace caustic
