#include "image/drawing_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace caustic {

namespace {

constexpr Real farthest = 2e6;  // of a coordinate on the canvas: what 32 bits hold, with room to spare
// OpenCV 4.6 paints anti-aliased shapes too large; measured for widths from 2 and radii from 5 canvas pixels.
constexpr Real lineExcess = 1.35;  // of a line's thickness, canvas pixels

std::string fontFile(const std::string& name) {
    constexpr std::array folders = {"/usr/share/fonts/truetype/dejavu/",
                                    "/usr/share/fonts/dejavu/",
                                    "/usr/share/fonts/dejavu-sans-fonts/",
                                    "/usr/share/fonts/TTF/",
                                    "/Library/Fonts/",
                                    "/opt/homebrew/share/fonts/"};
    for (const char* folder : folders) {
        const std::string file = folder + name;
        if (std::filesystem::exists(file)) return file;
    }
    throw InputError({name, 0}, "", "this font is not installed; Debian's package fonts-dejavu-core has it");
}

cv::Ptr<cv::freetype::FreeType2> loadFont(const std::string& name) {
    auto font = cv::freetype::createFreeType2();
    font->loadFontData(fontFile(name), 0);
    return font;
}

}  // namespace

int Drawing::Canvas::fixedLength(Real length) const {
    checkFinite(length, "length in a drawing");
    return static_cast<int>(std::lround(std::clamp(length * samples_, -farthest, farthest) * (1 << fractionBits)));
}

cv::Point Drawing::Canvas::fixed(const Vec2& place) const {
    const Real half = Real(0.5) / samples_;
    return {fixedLength(place.x() - half), fixedLength(place.y() - half)};
}

std::vector<cv::Point> Drawing::Canvas::fixed(const std::vector<Vec2>& places) const {
    std::vector<cv::Point> points;
    for (const Vec2& place : places) points.push_back(fixed(place));
    return points;
}

// OpenCV rounds a thickness up to an even number, and then paints a line wider than that.
int Drawing::Canvas::thickness(const Stroke& stroke) const {
    checkPositive(stroke.width, "width of a line");
    const Real inner = std::min(stroke.width * samples_, Real(1000)) - lineExcess;
    return std::max(1, 2 * static_cast<int>(std::lround(inner / 2)));
}

void Drawing::Canvas::paint(const Ink& ink, const Bounds2& where,
                            const std::function<void(cv::Mat&, const cv::Scalar&)>& draw) {
    if (ink.alpha >= 1) return draw(mat_, scalar(ink));
    const cv::Rect area = pixelsOf(where) & cv::Rect(0, 0, mat_.cols, mat_.rows);
    if (area.empty()) return;
    cv::Mat part = mat_(area);
    const cv::Mat before = part.clone();
    draw(mat_, scalar(ink));
    cv::addWeighted(part, ink.alpha, before, 1 - ink.alpha, 0, part);
}

cv::Rect Drawing::Canvas::pixelsOf(const Bounds2& box) const {
    const auto pixel = [&](Real x) { return static_cast<int>(std::clamp(x * samples_, -farthest, farthest)); };
    const cv::Point first(pixel(box.min().x()) - 2, pixel(box.min().y()) - 2);
    const cv::Point last(pixel(box.max().x()) + 3, pixel(box.max().y()) + 3);
    return {first, last};
}

cv::freetype::FreeType2& Drawing::Canvas::font(bool bold) {
    cv::Ptr<cv::freetype::FreeType2>& font = bold ? bold_ : regular_;
    if (!font) font = loadFont(bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf");
    return *font;
}

int Drawing::Canvas::fontSize(const TextStyle& style) const {
    checkPositive(style.size, "size of a text");
    return std::max(1, static_cast<int>(std::lround(std::min(style.size, Real(largestSide)) * samples_)));
}

Real Drawing::Canvas::inkWidth(const std::string& utf8, const TextStyle& style) {
    int baseline = 0;
    return font(style.bold).getTextSize(utf8, fontSize(style), cv::FILLED, &baseline).width;
}

cv::Mat Drawing::Canvas::finished() const {
    cv::Mat small;
    cv::resize(mat_, small, {mat_.cols / samples_, mat_.rows / samples_}, 0, 0, cv::INTER_AREA);
    return small;
}

}  // namespace caustic
