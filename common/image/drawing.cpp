#include "image/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "image/color_space.h"
#include "image/drawing_canvas.h"
#include "image/opencv_io.h"

namespace caustic {

namespace {

constexpr Real radiusExcess = 0.6;
constexpr Real capitalHeight = 0.729;  // of DejaVu Sans, in em
constexpr Real arrowHeadLength = 5;    // in line widths
constexpr Real arrowHeadHalfWidth = 2.2;

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
        cv::polylines(mat, pieces, false, color, thickness, cv::LINE_AA, Canvas::fractionBits);
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
        cv::fillPoly(mat, outline, color, cv::LINE_AA, Canvas::fractionBits);
    });
}

void Drawing::rectangle(const Bounds2& box, const Ink& fill) { polygon(corners(box), fill); }

void Drawing::rectangle(const Bounds2& box, const Stroke& outline) { polyline(corners(box), outline, true); }

void Drawing::circle(const Vec2& centre, Real radius, const Ink& fill) {
    checkPositive(radius, "radius of a circle");
    const cv::Point place = canvas_->fixed(centre);
    const Real inner = std::max(radius - radiusExcess / canvas_->samples(), Real(0));
    canvas_->paint(fill, boundsOf({centre}, radius + 1), [&](cv::Mat& mat, const cv::Scalar& color) {
        cv::circle(mat, place, canvas_->fixedLength(inner), color, cv::FILLED, cv::LINE_AA, Canvas::fractionBits);
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
    const cv::Point origin(fixed.x >> Canvas::fractionBits, fixed.y >> Canvas::fractionBits);
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
