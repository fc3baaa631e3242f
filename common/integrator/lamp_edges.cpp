#include "integrator/lamp_edges.h"

#include <algorithm>
#include <string>

#include "core/check.h"
#include "core/parallel.h"
#include "integrator/render.h"
#include "integrator/visible_point.h"

namespace caustic {

namespace {

constexpr std::uint64_t edgeStream = 3;  // paths from the eye, from lights and photons have 0, 1 and 2

constexpr int side = 4;  // paths of a pixel, squared

// Whether paths through all parts of the pixel see more than one thing.
bool seesAnEdge(const Scene& scene, const Sampler& sampler, const PathLimits& limits, Pixel pixel) {
    RayCounts counts;
    Color first = Color::Zero();
    for (int i = 0; i < side * side; ++i) {
        const PathNumbers numbers = sampler.start(edgeStream, pixel, i);
        const Vec2 u = numbers.pair(Dimension::film());
        const int column = i % side;
        const int row = i / side;
        const Vec2 film(pixel.x + (column + u.x()) / side, pixel.y + (row + u.y()) / side);
        const Ray ray = scene.camera().sampleRay(film, numbers.pair(Dimension::lens()));
        const Color seen = findVisiblePoint(scene, ray, scene.cameraMedia(), limits, numbers, counts).seen;
        if (i == 0) first = seen;
        if ((seen != first).any()) return true;
    }
    return false;
}

}  // namespace

std::vector<Pixel> lampEdges(const Scene& scene, const Sampler& sampler, const PathLimits& limits, int threads) {
    return withNeighbours(scene.camera(), edgesOfRows(scene, sampler, limits, 0, 1, threads));
}

std::vector<std::uint8_t> edgesOfRows(const Scene& scene, const Sampler& sampler, const PathLimits& limits, int first,
                                      int step, int threads) {
    const int width = scene.camera().width();
    const int height = scene.camera().height();
    std::vector<std::uint8_t> edges(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    const int rows = first < height ? (height - first + step - 1) / step : 0;
    parallelFor(rows, threads, [&](std::int64_t item) {
        const int y = first + static_cast<int>(item) * step;
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        for (int x = 0; x < width; ++x) {
            if (seesAnEdge(scene, sampler, limits, {x, y})) edges[row + static_cast<std::size_t>(x)] = 1;
        }
    });
    return edges;
}

std::vector<Pixel> withNeighbours(const Camera& camera, const std::vector<std::uint8_t>& edges) {
    const auto isEdge = [&](int x, int y) {
        return edges[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width()) +
                     static_cast<std::size_t>(x)] != 0;
    };
    const auto isNearOne = [&](int x, int y) {
        for (int j = std::max(0, y - 1); j <= std::min(camera.height() - 1, y + 1); ++j) {
            for (int i = std::max(0, x - 1); i <= std::min(camera.width() - 1, x + 1); ++i) {
                if (isEdge(i, j)) return true;
            }
        }
        return false;
    };
    std::vector<Pixel> pixels;
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            if (isNearOne(x, y)) pixels.push_back({x, y});
        }
    }
    return pixels;
}

std::vector<PathId> pathsOfPass(const Camera& camera, const std::vector<Pixel>& several, int paths, std::int64_t pass) {
    checkArgument(paths >= 1, "paths of a pixel in a pass", std::to_string(paths), "must be at least 1");
    std::vector<PathId> chosen = pathsOfAllPixels(camera, pass);
    const auto width = static_cast<std::size_t>(camera.width());
    for (const Pixel& pixel : several) {
        const std::int64_t first = pass * paths;
        chosen[static_cast<std::size_t>(pixel.y) * width + static_cast<std::size_t>(pixel.x)].index = first;
        for (int i = 1; i < paths; ++i) chosen.push_back({pixel, first + i});
    }
    return chosen;
}

std::function<std::vector<PathId>(const Rendering& soFar)> withMorePaths(const Camera& camera,
                                                                         const std::vector<Pixel>& several, int paths) {
    checkArgument(paths >= 1, "paths of a pixel in a pass", std::to_string(paths), "must be at least 1");
    return
        [&camera, several, paths](const Rendering& soFar) { return pathsOfPass(camera, several, paths, soFar.passes); };
}

}  // namespace caustic
