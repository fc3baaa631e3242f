#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/freetype.hpp>
#include <string>
#include <vector>

#include "image/drawing.h"

namespace caustic {

/// An ink as OpenCV takes it.
inline cv::Scalar scalar(const Ink& ink) { return {Real(ink.blue), Real(ink.green), Real(ink.red)}; }

/// What a Drawing paints on: the picture, `samples` times larger, and the fonts once they are needed.
class Drawing::Canvas {
public:
    /// Of OpenCV's fixed-point coordinates.
    static constexpr int fractionBits = 4;

    /// All of it in the paper's colour.
    Canvas(int width, int height, const Ink& paper, int samples)
        : samples_(samples), mat_(height * samples, width * samples, CV_8UC3, scalar(paper)) {}

    /// Canvas pixels for one of the picture's, each way.
    int samples() const { return samples_; }
    /// The large picture, as it is.
    cv::Mat& mat() { return mat_; }
    const cv::Mat& mat() const { return mat_; }

    /// A length in OpenCV's fixed point.
    int fixedLength(Real length) const;
    /// A place; OpenCV counts from the centre of the first pixel, we from its corner.
    cv::Point fixed(const Vec2& place) const;
    /// Places.
    std::vector<cv::Point> fixed(const std::vector<Vec2>& places) const;

    /// A line's thickness as OpenCV is to be asked for it.
    int thickness(const Stroke& stroke) const;

    /// Lets `draw` paint with an opaque colour, then lets what was there shine through.
    void paint(const Ink& ink, const Bounds2& where, const std::function<void(cv::Mat&, const cv::Scalar&)>& draw);

    /// The smallest rectangle of canvas pixels that surely holds the box.
    cv::Rect pixelsOf(const Bounds2& box) const;

    /// The font, read when it is first asked for.
    cv::freetype::FreeType2& font(bool bold);
    /// A text's size, canvas pixels.
    int fontSize(const TextStyle& style) const;
    /// Width of the box around a text's ink, in canvas pixels.
    Real inkWidth(const std::string& utf8, const TextStyle& style);

    /// The picture in its own size.
    cv::Mat finished() const;

private:
    int samples_;
    cv::Mat mat_;
    cv::Ptr<cv::freetype::FreeType2> regular_;
    cv::Ptr<cv::freetype::FreeType2> bold_;
};

}  // namespace caustic
