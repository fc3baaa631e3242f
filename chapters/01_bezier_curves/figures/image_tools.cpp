#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "figures.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "image/image_file.h"
#include "image/laplacian.h"
#include "image/spherical_map.h"

namespace caustic {

namespace {

using std::numbers::pi;

// The sheet: four columns, two rows; the panorama takes two columns, twice as wide as high.
constexpr int gap = 32;
constexpr int columnWidth = 370;
constexpr int titleHeight = 34;
constexpr int captionHeight = 30;
constexpr int upperHeight = 247;
constexpr int lowerHeight = (2 * columnWidth + gap) / 2;
constexpr int upperTop = 16 + titleHeight;
constexpr int lowerTop = upperTop + upperHeight + captionHeight + 16 + titleHeight;
constexpr int sheetWidth = 4 * columnWidth + 5 * gap;
constexpr int sheetHeight = lowerTop + lowerHeight + captionHeight + 16;

const TextStyle small{14, palette::dark};
const TextStyle smallCentred{14, palette::dark, false, HorizontalAnchor::Centre, VerticalAnchor::Middle};

Bounds2 panel(int row, int column, int columns = 1) {
    const Vec2 corner(gap + column * (columnWidth + gap), row == 0 ? upperTop : lowerTop);
    const Vec2 size(columns * columnWidth + (columns - 1) * gap, row == 0 ? upperHeight : lowerHeight);
    return {corner, corner + size};
}

int wide(const Bounds2& box) { return static_cast<int>(box.sizes().x()); }
int high(const Bounds2& box) { return static_cast<int>(box.sizes().y()); }

void caption(Drawing& sheet, const Bounds2& box, const std::string& title, const std::string& below) {
    sheet.text({box.min().x(), box.min().y() - 11}, title, {18, palette::text, true});
    sheet.text({box.min().x(), box.max().y() + 20}, below, small);
}

void frame(Drawing& sheet, const Bounds2& box) { sheet.rectangle(box, Stroke{palette::dark, 1.2}); }

// An image whose pixels are the mean of function(x, y) at 3 × 3 places in each; coordinates in pixels.
template <typename Function>
Image painted(int width, int height, const Function& function) {
    constexpr int samples = 3;
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum = Color::Zero();
            for (int i = 0; i < samples * samples; ++i) {
                sum += function(x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples);
            }
            image.set(x, y, sum / (samples * samples));
        }
    }
    return image;
}

// A subject with edges, smooth shading and small highlights: three balls on a table. x in [0, 1.5], y in [0, 1].
Color stillLife(Real x, Real y) {
    struct Ball {
        Real x, y, radius, hue;
    };
    constexpr Ball balls[] = {{0.42, 0.52, 0.27, 0.58}, {1.05, 0.44, 0.33, 0.06}, {0.76, 0.74, 0.17, 0.38}};
    const Vec3 light = Vec3(-0.5, -0.7, 0.6).normalized();
    Color color = y < 0.62 ? Color(0.75, 0.8, 0.88) * (1 - 0.35 * y) : Color(0.42, 0.33, 0.25) * (0.5 + 0.7 * y);
    for (const Ball& ball : balls) {
        const Real shadow =
            std::hypot((x - ball.x - 0.1) / 1.25, (y - ball.y - 0.85 * ball.radius) / 0.3) / ball.radius;
        color *= std::clamp(shadow, Real(0.35), Real(1));
    }
    for (const Ball& ball : balls) {
        const Vec2 offset = Vec2(x - ball.x, y - ball.y) / ball.radius;
        if (offset.squaredNorm() >= 1) continue;
        const Vec3 normal(offset.x(), offset.y(), std::sqrt(1 - offset.squaredNorm()));
        const Real diffuse = std::max(normal.dot(light), Real(0));
        const Real mirrored = std::max(2 * normal.dot(light) * normal.z() - light.z(), Real(0));
        color = srgbDecode(hsvToRgb(ball.hue, 0.85, 0.95)) * (0.1 + 0.9 * diffuse) + 0.9 * std::pow(mirrored, 60);
    }
    return color;
}

// A world to look around in: sky, sun, a chequered plain, and a pillar of its own hue every 45 degrees.
Color world(const Vec3& direction) {
    const Real elevation = std::asin(std::clamp(direction.z(), Real(-1), Real(1)));
    const Real azimuth = std::atan2(direction.y(), direction.x());
    const Real eighth = std::round(azimuth / (pi / 4));
    const bool pillar = std::abs(azimuth - eighth * pi / 4) < 0.07 && elevation > -0.2 && elevation < 0.38;
    if (pillar) return srgbDecode(hsvToRgb(eighth / 8, 0.75, 0.9));
    const Color haze(0.75, 0.82, 0.9);
    if (elevation > 0) {
        const Real towardsSun = direction.dot(Vec3(0.75, 0.45, 0.5).normalized());
        const Color sky = haze + (Color(0.06, 0.2, 0.6) - haze) * std::min(1.6 * elevation, Real(1));
        const Color glow = Color(1, 0.85, 0.6) * 0.7 * std::pow(std::max(towardsSun, Real(0)), 60);
        return towardsSun > std::cos(0.06) ? Color(40, 34, 24) : Color(sky + glow);
    }
    const Vec2 ground = direction.head<2>() / std::max(-direction.z(), Real(1e-6));
    const bool even = std::fmod(std::floor(ground.x()) + std::floor(ground.y()), 2) == 0;
    const Real fog = 1 - std::exp(-ground.norm() / 12);
    return (even ? Color(0.5, 0.47, 0.4) : Color(0.16, 0.17, 0.16)) * (1 - fog) + haze * fog;
}

void drawLookUps(Drawing& sheet) {
    constexpr int width = 30;
    constexpr int height = 20;
    const Image coarse = painted(width, height, [](Real x, Real y) { return stillLife(x / height, y / height); });
    const Bounds2 left = panel(0, 0);
    const Bounds2 right = panel(0, 1);
    const Real scale = left.sizes().x() / width;
    sheet.image(painted(wide(left), high(left), [&](Real x, Real y) { return coarse.nearest(x / scale, y / scale); }),
                left);
    sheet.image(
        painted(wide(right), high(right), [&](Real x, Real y) { return coarse.bilinear(x / scale, y / scale); }),
        right);
    caption(sheet, left, "Nearest look-up",
            std::to_string(width) + " × " + std::to_string(height) + " pixels, enlarged");
    caption(sheet, right, "Bilinear look-up", "the same pixels, interpolated between their centres");
}

void drawEdges(Drawing& sheet) {
    const Bounds2 box = panel(0, 2);
    const Image fine =
        painted(wide(box), high(box), [&](Real x, Real y) { return stillLife(x / upperHeight, y / upperHeight); });
    const Image edges = laplacian(fine);
    sheet.image(painted(wide(box), high(box),
                        [&](Real x, Real y) {
                            const Real edge = edges.nearest(x, y).abs().maxCoeff();
                            return Color::Constant(1 / (1 + 25 * edge));
                        }),
                box);
    caption(sheet, box, "Laplacian", "dark where the picture bends: at edges");
}

std::string withDigits(const char* format, Real value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// Writes the panorama in every format and reads it back: what is left of it, and what it costs.
void drawFiles(Drawing& sheet, const Image& panorama, FigureContext& context) {
    struct Format {
        const char* name;
        const char* file;
        PngDepth depth;
    };
    constexpr Format formats[] = {{"PNG, 8 bits", "image_tools_8.png", PngDepth::Bits8},
                                  {"PNG, 16 bits", "image_tools_16.png", PngDepth::Bits16},
                                  {"Radiance", "image_tools.hdr", PngDepth::Bits8},
                                  {"OpenEXR", "image_tools.exr", PngDepth::Bits8}};
    const Bounds2 box = panel(0, 3);
    const Real right[] = {box.min().x() + 158, box.min().x() + 220, box.max().x() - 14};
    const char* const heads[] = {"KiB", "sun", "mean error"};
    const auto put = [&](int column, Real y, const std::string& text, bool bold) {
        sheet.text({right[column], y}, text, {15, palette::text, bold, HorizontalAnchor::Right});
    };
    Real y = box.min().y() + 40;
    sheet.text({box.min().x() + 14, y}, "format", {15, palette::text, true});
    for (int column = 0; column < 3; ++column) put(column, y, heads[column], true);
    sheet.line({box.min().x() + 14, y + 12}, {box.max().x() - 14, y + 12}, Stroke{palette::dark, 1});
    for (const Format& format : formats) {
        // A scratch file beside the figure, not one of its outputs.
        const std::filesystem::path file = context.output("image_tools.png").parent_path() / format.file;
        saveImage(file, panorama, format.depth);
        const Image back = loadImage(file);
        const Real kibibytes = Real(std::filesystem::file_size(file)) / 1024;
        std::filesystem::remove(file);
        Real error = 0;
        Real brightest = 0;
        for (std::size_t i = 0; i < back.data().size(); ++i) {
            const Real before = Real(panorama.data()[i]);
            const Real after = Real(back.data()[i]);
            brightest = std::max(brightest, after);
            error += std::abs(after - before) / std::max(before, Real(1e-6)) / Real(back.data().size());
        }
        y += 42;
        sheet.text({box.min().x() + 14, y}, format.name, {15});
        put(0, y, withDigits("%.0f", kibibytes), false);
        put(1, y, withDigits("%.3g", brightest), false);
        put(2, y, error > 0 ? withDigits("%.4f %%", 100 * error) : "none", false);
    }
    frame(sheet, box);
    caption(sheet, box, "Files, written and read", "the panorama below; white is 1, its sun 40");
}

void drawWheel(Drawing& sheet) {
    const Bounds2 box = panel(1, 0);
    const Vec2 centre(box.min().x() + 166, box.center().y());
    constexpr Real radius = 124;
    const Bounds2 square(centre.array() - radius, centre.array() + radius);
    sheet.image(painted(wide(square), high(square),
                        [](Real x, Real y) {
                            const Vec2 offset(x / radius - 1, 1 - y / radius);
                            if (offset.norm() > 1) return Color(1, 1, 1);
                            const Real hue = std::atan2(offset.y(), offset.x()) / (2 * pi);
                            return srgbDecode(hsvToRgb(hue, offset.norm(), 1));
                        }),
                square);
    sheet.circle(centre, radius, Stroke{palette::dark, 1.2});
    const char* const names[] = {"0", "1/6", "1/3", "1/2", "2/3", "5/6"};
    for (int i = 0; i < 6; ++i) {
        const Real angle = i * pi / 3;
        sheet.text(centre + (radius + 20) * Vec2(std::cos(angle), -std::sin(angle)), names[i], smallCentred);
    }
    const Bounds2 bar(Vec2(box.max().x() - 48, centre.y() - radius), Vec2(box.max().x() - 20, centre.y() + radius));
    sheet.image(painted(1, high(bar), [&](Real, Real y) { return srgbDecode(hsvToRgb(0.58, 0.8, 1 - y / high(bar))); }),
                bar);
    frame(sheet, bar);
    sheet.text({bar.center().x(), bar.min().y() - 12}, "V = 1", smallCentred);
    sheet.text({bar.center().x(), bar.max().y() + 12}, "0", smallCentred);
    sheet.text({centre.x(), box.min().y() + 18}, "hue in turns", smallCentred);
    frame(sheet, box);
    caption(sheet, box, "HSV → RGB", "hue around, saturation outwards; value in the bar");
}

void drawPanorama(Drawing& sheet, const Image& panorama) {
    const Bounds2 box = panel(1, 1, 2);
    sheet.image(panorama, box);
    frame(sheet, box);
    const char* const looks[] = {"−x", "+y", "+x", "−y", "−x"};
    for (int i = 0; i <= 4; ++i) {
        const Vec2 place(box.min().x() + i * box.sizes().x() / 4, box.max().y());
        const HorizontalAnchor anchor = i == 0   ? HorizontalAnchor::Left
                                        : i == 4 ? HorizontalAnchor::Right
                                                 : HorizontalAnchor::Centre;
        sheet.line(place, place + Vec2(0, 6), Stroke{palette::dark, 1.2});
        sheet.text(place + Vec2(0, 21), looks[i], {14, palette::dark, false, anchor});
    }
    sheet.text({box.min().x(), box.min().y() - 11}, "Panorama", {18, palette::text, true});
    sheet.text({box.max().x(), box.min().y() - 11},
               "zenith at the top, nadir at the bottom; x, y: where a column looks",
               {14, palette::dark, false, HorizontalAnchor::Right});
}

void drawMirrorBall(Drawing& sheet, const Image& panorama) {
    const Bounds2 box = panel(1, 3);
    const Real ball = 0.4 * box.sizes().x();
    // The camera looks along +x: −y lies to its right. Seen from afar, so that all rays at the ball are parallel.
    const auto seen = [&](Real x, Real y) {
        const Vec2 screen = (Vec2(x, y) - box.sizes() / 2) / ball;
        const Vec3 forward(1, 0, 0);
        if (screen.squaredNorm() >= 1) return lookUpSpherical(panorama, Vec3(2, -screen.x(), -screen.y()));
        const Vec3 normal(-std::sqrt(1 - screen.squaredNorm()), -screen.x(), -screen.y());
        return lookUpSpherical(panorama, forward - 2 * forward.dot(normal) * normal);
    };
    sheet.image(painted(wide(box), high(box), seen), box);
    frame(sheet, box);
    caption(sheet, box, "Spherical look-up", "the view along +x, and a mirror ball in it");
}

}  // namespace

void drawImageTools(FigureContext& context) {
    constexpr int width = 2 * lowerHeight;
    const Image panorama = painted(
        width, lowerHeight, [](Real x, Real y) { return world(uvToSpherical(Vec2(x / width, y / lowerHeight))); });
    Drawing sheet(sheetWidth, sheetHeight);
    drawLookUps(sheet);
    drawEdges(sheet);
    drawFiles(sheet, panorama, context);
    drawWheel(sheet);
    drawPanorama(sheet, panorama);
    drawMirrorBall(sheet, panorama);
    for (int column = 0; column < 3; ++column) frame(sheet, panel(0, column));
    sheet.save(context.output("image_tools.png"));
}

}  // namespace caustic
