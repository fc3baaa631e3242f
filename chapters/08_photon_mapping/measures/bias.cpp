#include <cmath>

#include "core/parallel.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "measures/floor_caustic.h"

namespace caustic {

namespace {

constexpr int longest = 64;

struct BiasAndNoise {
    Real bias = 0;   // of the mean picture, rms
    Real noise = 0;  // of one picture, rms
};

// From several pictures of independent maps. The mean picture's own noise is taken out of the bias.
BiasAndNoise apart(const std::vector<Image>& pictures, const Image& reference) {
    const auto count = static_cast<Real>(pictures.size());
    Real squaredBias = 0;
    Real variance = 0;
    for (int y = 0; y < reference.height(); ++y) {
        for (int x = 0; x < reference.width(); ++x) {
            Color mean = Color::Zero();
            for (const Image& one : pictures) mean += one.at(x, y) / count;
            Color scatter = Color::Zero();
            for (const Image& one : pictures) scatter += (one.at(x, y) - mean).square() / (count - 1);
            squaredBias += ((mean - reference.at(x, y)).square() - scatter / count).mean();
            variance += scatter.mean();
        }
    }
    const auto pixels = static_cast<Real>(reference.width() * reference.height());
    return {std::sqrt(std::max(Real(0), squaredBias / pixels)), std::sqrt(variance / pixels)};
}

}  // namespace

void chartBias(FigureContext& context) {
    const FloorCaustic floor(context);
    const std::vector<int> ks = {2, 4, 8, 16, 32, 64, 128, 256, 512};
    constexpr std::int64_t photons = 64'000;
    const int maps = context.byQuality(2, 8);
    CsvTable table({"method", "setting", "bias", "noise", "error_unit"});
    const std::vector<std::pair<std::string, Real>> filters = {{"no filter", 0}, {"cone filter", 1}};
    const std::size_t runs = filters.size() * ks.size();
    std::vector<BiasAndNoise> found(runs);
    context.progress().expect(static_cast<std::int64_t>(runs));
    parallelFor(static_cast<std::int64_t>(runs), context.threads(), [&](std::int64_t item) {
        const auto at = static_cast<std::size_t>(item);
        PhotonMapperSettings settings = {.photons = photons, .limits = {longest, 1}};
        settings.density = {.nearest = ks[at % ks.size()], .radius = 0.5, .cone = filters[at / ks.size()].second};
        settings.caustics = settings.density;
        std::vector<Image> pictures;
        for (int i = 0; i < maps; ++i)
            pictures.push_back(floor.byPhotons(settings, 4, context.seed() + static_cast<std::uint64_t>(i)).picture);
        found[at] = apart(pictures, floor.reference());
        context.progress().advance();
    });
    for (std::size_t i = 0; i < runs; ++i)
        table.addRow(filters[i / ks.size()].first, "k=" + std::to_string(ks[i % ks.size()]), found[i].bias,
                     found[i].noise, "radiance (rms)");
    table.save(context.output("bias.csv"));
    context.chart("measures/bias.gp", "bias.png");
}

}  // namespace caustic
