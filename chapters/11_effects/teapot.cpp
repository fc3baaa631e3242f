#include "teapot.h"

#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "shape/shape_tree.h"
#include "surface/patch_surface.h"

namespace caustic {

namespace {

constexpr std::size_t mostBytes = std::size_t{1} << 20;

// Without comments, so that words and numbers are left.
std::istringstream wordsOf(const std::string& text) {
    std::istringstream lines(text);
    std::string words;
    for (std::string line; std::getline(lines, line);) words += line.substr(0, line.find('#')) + '\n';
    return std::istringstream(words);
}

}  // namespace

std::shared_ptr<const Shape> loadTeapot(const std::filesystem::path& file) {
    std::istringstream words = wordsOf(readTextFile(file, mostBytes));
    std::vector<std::shared_ptr<const Shape>> patches;
    std::string word;
    std::string name;
    int m = 0;
    int n = 0;
    while (words >> word) {
        if (word != "patch" || !(words >> name >> m >> n) || m < 1 || n < 1 || m > 9 || n > 9)
            throw InputError({file.string(), 0}, word, "expected 'patch', a name and two degrees");
        std::vector<Vec3> points(static_cast<std::size_t>((m + 1) * (n + 1)));
        for (Vec3& point : points) words >> point.x() >> point.y() >> point.z();
        if (!words) throw InputError({file.string(), 0}, name, "ends within this patch");
        patches.push_back(std::make_shared<PatchSurface>(BezierPatch(m, n, std::move(points))));
    }
    if (patches.empty()) throw InputError({file.string(), 0}, "", "has no patch");
    return std::make_shared<ShapeTree>(std::move(patches));
}

}  // namespace caustic
