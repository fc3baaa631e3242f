#include "image/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "image/color_space.h"
#include "image/opencv_io.h"

namespace caustic {

namespace {

constexpr int fractionBits = 4;  // of OpenCV's fixed-point coordinates
constexpr Real farthest = 2e6;   // of a coordinate on the canvas: what 32 bits hold, with room to spare
// OpenCV 4.6 paints anti-aliased shapes too large; measured for widths from 2 and radii from 5 canvas pixels.
constexpr Real lineExcess = 1.35;  // of a line's thickness, canvas pixels
constexpr Real radiusExcess = 0.6;
constexpr Real capitalHeight = 0.729;  // of DejaVu Sans, in em
constexpr Real arrowHeadLength = 5;    // in line widths
constexpr Real arrowHeadHalfWidth = 2.2;

cv::Scalar scalar(const Ink& ink) { return {Real(ink.blue), Real(ink.green), Real(ink.red)}; }

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

// Cuts a line into dashes with gaps as long between them.
std::vector<std::vector<Vec2>> dashes(const std::vector<Vec2>& points, Real length) {
    std::vector<std::vector<Vec2>> pieces = {{points.front()}};
    Real left = length;  // of the current dash or gap
    bool drawn = true;
    for (std::size_t i = 1; i < points.size(); ++i) {
        Vec2 from = points[i - 1];
        for (Real way = (points[i] - from).norm(); way > left; way = (points[i] - from).norm()) {
            from += (points[i] - from) * (left / way);
            if (drawn)
                pieces.back().push_back(from);
            else
                pieces.push_back({from});
            drawn = !drawn;
            left = length;
        }
        left -= (points[i] - from).norm();
        if (drawn) pieces.back().push_back(points[i]);
    }
    return pieces;
}

}  // namespace

// The picture, `samples` times larger, and the fonts once they are needed.
class Drawing::Canvas {
public:
    Canvas(int width, int height, const Ink& paper, int samples)
        : samples_(samples), mat_(height * samples, width * samples, CV_8UC3, scalar(paper)) {}

    int samples() const { return samples_; }
    cv::Mat& mat() { return mat_; }
    const cv::Mat& mat() const { return mat_; }

    // A length in OpenCV's fixed point.
    int fixedLength(Real length) const {
        checkFinite(length, "length in a drawing");
        return static_cast<int>(std::lround(std::clamp(length * samples_, -farthest, farthest) * (1 << fractionBits)));
    }

    // OpenCV counts from the centre of the first pixel, we from its corner.
    cv::Point fixed(const Vec2& place) const {
        const Real half = Real(0.5) / samples_;
        return {fixedLength(place.x() - half), fixedLength(place.y() - half)};
    }

    std::vector<cv::Point> fixed(const std::vector<Vec2>& places) const {
        std::vector<cv::Point> points;
        for (const Vec2& place : places) points.push_back(fixed(place));
        return points;
    }

    // OpenCV rounds a thickness up to an even number, and then paints a line wider than that.
    int thickness(const Stroke& stroke) const {
        checkPositive(stroke.width, "width of a line");
        const Real inner = std::min(stroke.width * samples_, Real(1000)) - lineExcess;
        return std::max(1, 2 * static_cast<int>(std::lround(inner / 2)));
    }

    // Lets `draw` paint with an opaque colour, then lets what was there shine through.
    void paint(const Ink& ink, const Bounds2& where, const std::function<void(cv::Mat&, const cv::Scalar&)>& draw) {
        if (ink.alpha >= 1) return draw(mat_, scalar(ink));
        const cv::Rect area = pixelsOf(where) & cv::Rect(0, 0, mat_.cols, mat_.rows);
        if (area.empty()) return;
        cv::Mat part = mat_(area);
        const cv::Mat before = part.clone();
        draw(mat_, scalar(ink));
        cv::addWeighted(part, ink.alpha, before, 1 - ink.alpha, 0, part);
    }

    // The smallest rectangle of canvas pixels that surely holds the box.
    cv::Rect pixelsOf(const Bounds2& box) const {
        const auto pixel = [&](Real x) { return static_cast<int>(std::clamp(x * samples_, -farthest, farthest)); };
        const cv::Point first(pixel(box.min().x()) - 2, pixel(box.min().y()) - 2);
        const cv::Point last(pixel(box.max().x()) + 3, pixel(box.max().y()) + 3);
        return {first, last};
    }

    cv::freetype::FreeType2& font(bool bold) {
        cv::Ptr<cv::freetype::FreeType2>& font = bold ? bold_ : regular_;
        if (!font) font = loadFont(bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf");
        return *font;
    }

    int fontSize(const TextStyle& style) const {
        checkPositive(style.size, "size of a text");
        return std::max(1, static_cast<int>(std::lround(std::min(style.size, Real(largestSide)) * samples_)));
    }

    // Width of the box around a text's ink, in canvas pixels.
    Real inkWidth(const std::string& utf8, const TextStyle& style) {
        int baseline = 0;
        return font(style.bold).getTextSize(utf8, fontSize(style), cv::FILLED, &baseline).width;
    }

    cv::Mat finished() const {
        cv::Mat small;
        cv::resize(mat_, small, {mat_.cols / samples_, mat_.rows / samples_}, 0, 0, cv::INTER_AREA);
        return small;
    }

private:
    int samples_;
    cv::Mat mat_;
    cv::Ptr<cv::freetype::FreeType2> regular_;
    cv::Ptr<cv::freetype::FreeType2> bold_;
};

namespace {

Bounds2 boundsOf(const std::vector<Vec2>& points, Real margin) {
    Bounds2 box;
    for (const Vec2& point : points) box.extend(point);
    return {box.min().array() - margin, box.max().array() + margin};
}

std::vector<Vec2> corners(const Bounds2& box) {
    return {box.corner(Bounds2::BottomLeft), box.corner(Bounds2::BottomRight), box.corner(Bounds2::TopRight),
            box.corner(Bounds2::TopLeft)};
}

// The image's sRGB codes, blue first.
cv::Mat encoded(const Image& image) {
    cv::Mat codes(image.height(), image.width(), CV_8UC3);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Color code = (255 * srgbEncode(image.at(x, y))).round();
            codes.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(code.z()), static_cast<std::uint8_t>(code.y()),
                                         static_cast<std::uint8_t>(code.x())};
        }
    }
    return codes;
}

void checkSide(int side, const std::string& what) {
    checkArgument(side >= 1 && side <= Drawing::largestSide, what, std::to_string(side),
                  "must lie between 1 and " + std::to_string(Drawing::largestSide) + " pixels");
}

}  // namespace

Drawing::Drawing(int width, int height, const Ink& paper, int samples) {
    checkSide(width, "width of a drawing");
    checkSide(height, "height of a drawing");
    checkArgument(samples >= 1 && samples <= 8, "samples of a drawing", std::to_string(samples),
                  "must lie between 1 and 8");
    canvas_ = std::make_unique<Canvas>(width, height, paper, samples);
}

Drawing::~Drawing() = default;
Drawing::Drawing(Drawing&&) noexcept = default;
Drawing& Drawing::operator=(Drawing&&) noexcept = default;

int Drawing::width() const { return canvas_->mat().cols / canvas_->samples(); }
int Drawing::height() const { return canvas_->mat().rows / canvas_->samples(); }

void Drawing::clear(const Ink& paper) { canvas_->mat().setTo(scalar(paper)); }

void Drawing::line(const Vec2& from, const Vec2& to, const Stroke& stroke) { polyline({from, to}, stroke); }

void Drawing::polyline(const std::vector<Vec2>& points, const Stroke& stroke, bool closed) {
    if (points.empty()) return;
    checkArgument(stroke.dash == 0 || stroke.dash >= 1, "dash of a line", formatReal(stroke.dash),
                  "must be 0 (solid) or at least a pixel");
    std::vector<Vec2> path = points;
    if (closed) path.push_back(points.front());
    std::vector<std::vector<cv::Point>> pieces;
    if (stroke.dash > 0) {
        for (const auto& dash : dashes(path, stroke.dash)) pieces.push_back(canvas_->fixed(dash));
    } else {
        pieces.push_back(canvas_->fixed(path));
    }
    const int thickness = canvas_->thickness(stroke);
    canvas_->paint(stroke.ink, boundsOf(path, stroke.width), [&](cv::Mat& mat, const cv::Scalar& color) {
        cv::polylines(mat, pieces, false, color, thickness, cv::LINE_AA, fractionBits);
    });
}

void Drawing::arrow(const Vec2& from, const Vec2& to, const Stroke& stroke) {
    const Real length = (to - from).norm();
    if (!(length > 0)) return;
    const Vec2 along = (to - from) / length;
    const Vec2 across(-along.y(), along.x());
    const Real head = std::min(arrowHeadLength * stroke.width, length);
    const Real half = head * arrowHeadHalfWidth / arrowHeadLength;
    const Vec2 neck = to - head * along;
    if (length > head) line(from, neck + head / 4 * along, stroke);
    polygon({to, neck + half * across, neck - half * across}, stroke.ink);
}

void Drawing::polygon(const std::vector<Vec2>& points, const Ink& fill) {
    if (points.empty()) return;
    const std::vector<std::vector<cv::Point>> outline = {canvas_->fixed(points)};
    canvas_->paint(fill, boundsOf(points, 1), [&](cv::Mat& mat, const cv::Scalar& color) {
        cv::fillPoly(mat, outline, color, cv::LINE_AA, fractionBits);
    });
}

void Drawing::rectangle(const Bounds2& box, const Ink& fill) { polygon(corners(box), fill); }

void Drawing::rectangle(const Bounds2& box, const Stroke& outline) { polyline(corners(box), outline, true); }

void Drawing::circle(const Vec2& centre, Real radius, const Ink& fill) {
    checkPositive(radius, "radius of a circle");
    const cv::Point place = canvas_->fixed(centre);
    const Real inner = std::max(radius - radiusExcess / canvas_->samples(), Real(0));
    canvas_->paint(fill, boundsOf({centre}, radius + 1), [&](cv::Mat& mat, const cv::Scalar& color) {
        cv::circle(mat, place, canvas_->fixedLength(inner), color, cv::FILLED, cv::LINE_AA, fractionBits);
    });
}

void Drawing::circle(const Vec2& centre, Real radius, const Stroke& outline) {
    checkPositive(radius, "radius of a circle");
    // Pieces of one and a half pixels: more would make the line bolder where their soft edges meet.
    const int corners = static_cast<int>(std::clamp(4 * radius, Real(16), Real(256)));
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const Real angle = 2 * std::numbers::pi * i / corners;
        points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    polyline(points, outline, true);
}

void Drawing::text(const Vec2& place, const std::string& utf8, const TextStyle& style) {
    if (utf8.empty()) return;
    Vec2 start = place;
    const Real end = textWidth(utf8, style);
    const Real firstInk = end - canvas_->inkWidth(utf8, style) / canvas_->samples();
    if (style.horizontal == HorizontalAnchor::Centre) start.x() -= (firstInk + end) / 2;
    if (style.horizontal == HorizontalAnchor::Right) start.x() -= end;
    if (style.vertical == VerticalAnchor::Middle) start.y() += capitalHeight / 2 * style.size;
    const cv::Point fixed = canvas_->fixed(start);
    const cv::Point origin(fixed.x >> fractionBits, fixed.y >> fractionBits);
    canvas_->font(style.bold)
        .putText(canvas_->mat(), utf8, origin, canvas_->fontSize(style), scalar(style.ink), cv::FILLED, cv::LINE_AA,
                 true);
}

Real Drawing::textWidth(const std::string& utf8, const TextStyle& style) const {
    if (utf8.empty()) return 0;
    // The box starts at the first ink, not at the place of the text; a space before it moves its start there.
    const Real space = canvas_->inkWidth("  ", style) - canvas_->inkWidth(" ", style);
    return (canvas_->inkWidth(" " + utf8, style) - space) / canvas_->samples();
}

void Drawing::image(const Image& image, const Bounds2& box) {
    checkArgument(!box.isEmpty() && box.min().allFinite() && box.max().allFinite(), "box of an image", "",
                  "must be a finite box that is not empty");
    cv::Mat& mat = canvas_->mat();
    const cv::Mat codes = encoded(image);
    const Vec2 perPixel(image.width() / box.sizes().x(), image.height() / box.sizes().y());
    const cv::Rect area = canvas_->pixelsOf(box) & cv::Rect(0, 0, mat.cols, mat.rows);
    for (int y = area.y; y < area.y + area.height; ++y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            const Vec2 place = Vec2(x + 0.5, y + 0.5) / canvas_->samples();
            if (!box.contains(place)) continue;
            const Vec2 pixel = (place - box.min()).cwiseProduct(perPixel);
            const int column = std::min(static_cast<int>(pixel.x()), image.width() - 1);
            const int row = std::min(static_cast<int>(pixel.y()), image.height() - 1);
            mat.at<cv::Vec3b>(y, x) = codes.at<cv::Vec3b>(row, column);
        }
    }
}

std::vector<std::uint8_t> Drawing::bgr() const {
    const cv::Mat mat = canvas_->finished();
    return {mat.datastart, mat.dataend};
}

void Drawing::save(const std::filesystem::path& path) const {
    checkArgument(path.extension() == ".png", path.string(), path.extension().string(), "drawings are saved as .png");
    writeMat(path, canvas_->finished());
}

}  // namespace caustic
