#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "image/image.h"
#include "image/tiles.h"
#include "measures/photon_pattern.h"

namespace caustic {

void drawEmission(FigureContext& context) {
    constexpr int width = 440;
    std::vector<Tile> tiles;
    for (const Emission& way : emissions(context.seed())) {
        const Image picture = PhotonPattern(*way.sampler, width / 2, 0, context.threads()).picture();
        tiles.push_back({way.name, [picture](int, int) {
                             Image shown(picture.width(), picture.height());
                             for (int y = 0; y < shown.height(); ++y) {
                                 for (int x = 0; x < shown.width(); ++x) shown.set(x, y, 0.3 * picture.at(x, y));
                             }
                             return shown;
                         }});
    }
    drawTiles(tiles, width, width, "emission.png", context, 2);
}

void chartSpectrum(FigureContext& context) {
    CsvTable table({"method", "frequency", "frequency_unit", "power", "power_unit"});
    const auto ways = emissions(context.seed());
    context.progress().expect(static_cast<std::int64_t>(ways.size()));
    const int passes = context.byQuality(2, 16);
    for (const Emission& way : ways) {
        std::vector<Real> mean(128, 0);
        for (int pass = 0; pass < passes; ++pass) {
            const auto spectrum =
                PhotonPattern(*way.sampler, 256, pass * PhotonPattern::photons, context.threads()).spectrum();
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += spectrum.power[i] / passes;
        }
        for (std::size_t i = 1; i < mean.size(); ++i)
            table.addRow(way.name, i, "periods across the picture", mean[i], "of random photons'");
        context.progress().advance();
    }
    table.save(context.output("spectrum.csv"));
    context.chart("measures/spectrum.gp", "spectrum.png");
}

}  // namespace caustic
