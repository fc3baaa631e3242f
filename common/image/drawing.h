#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/palette.h"
#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// How a line looks. Lengths in pixels.
struct Stroke {
    Ink ink = palette::dark;  ///< colour and alpha
    Real width = 2;           ///< greater than 0
    Real dash = 0;            ///< length of dashes and of the gaps between them; at least 1, or 0 for a solid line
};

/// Which point of a text stands at the place where it is put, from left to right.
enum class HorizontalAnchor {
    Left,    ///< where writing begins
    Centre,  ///< the middle of its ink
    Right    ///< where its ink ends
};
/// The same upwards.
enum class VerticalAnchor {
    Baseline,  ///< what letters stand on
    Middle     ///< half the height of a capital letter
};

/// How a text looks.
struct TextStyle {
    Real size = 16;                                        ///< height of the font (its em), pixels
    Ink ink = palette::text;                               ///< colour; alpha is not heeded
    bool bold = false;                                     ///< heavier
    HorizontalAnchor horizontal = HorizontalAnchor::Left;  ///< what stands at the place
    VerticalAnchor vertical = VerticalAnchor::Baseline;    ///< what stands at the place
};

/// A picture to draw on: lines, shapes and text, anti-aliased by drawing `samples` times larger along both axes.
///
/// Places are in pixels of the finished picture, x to the right and y down from its upper left corner; the centre of
/// its first pixel is (0.5, 0.5). What lies outside is cut off. Coordinates must be finite (InputError otherwise). The
/// same calls give the same bytes, whatever the threads. A line's width and a polygon's edge are right to one sample.
/// Text is UTF-8, set in DejaVu Sans; its ink's alpha is not heeded.
class Drawing {
public:
    /// Pixels; more is refused.
    static constexpr int largestSide = 4096;

    /// @param samples  per pixel and axis; 4 for figures, fewer where speed counts
    /// @throws InputError for sides outside [1, largestSide] or samples outside [1, 8]
    Drawing(int width, int height, const Ink& paper = palette::white, int samples = 4);
    ~Drawing();
    /// Moves the picture; what is left behind can only be assigned to.
    Drawing(Drawing&&) noexcept;
    /// The same.
    Drawing& operator=(Drawing&&) noexcept;

    /// Size of the finished picture in pixels.
    /// Pixels in a row of the finished picture.
    int width() const;
    /// Rows of the finished picture.
    int height() const;

    /// Paints everything over.
    void clear(const Ink& paper);

    /// A straight line with round ends.
    /// A straight line with round ends.
    void line(const Vec2& from, const Vec2& to, const Stroke& stroke);
    /// Straight lines from point to point with round ends and corners; `closed` leads back to the first.
    void polyline(const std::vector<Vec2>& points, const Stroke& stroke, bool closed = false);
    /// A line with a filled head whose tip is at `to`.
    void arrow(const Vec2& from, const Vec2& to, const Stroke& stroke);

    /// Filled polygon, even-odd where it crosses itself.
    void polygon(const std::vector<Vec2>& points, const Ink& fill);
    /// Filled box.
    void rectangle(const Bounds2& box, const Ink& fill);
    /// The outline of a box; half of its width lies inside.
    void rectangle(const Bounds2& box, const Stroke& outline);
    /// Filled disc; the radius must be greater than 0.
    void circle(const Vec2& centre, Real radius, const Ink& fill);
    /// The outline of a disc; half of its width lies inside.
    void circle(const Vec2& centre, Real radius, const Stroke& outline);

    /// Writes one line of text at a place.
    void text(const Vec2& place, const std::string& utf8, const TextStyle& style = {});
    /// How far a text reaches to the right of its place when that is its left end, in pixels.
    Real textWidth(const std::string& utf8, const TextStyle& style = {}) const;

    /// An image (sRGB-encoded, values clamped) stretched over a box; its pixels stay squares with sharp edges.
    void image(const Image& image, const Bounds2& box);

    /// The finished picture: 8-bit blue, green, red per pixel, rows from the top (the order of OpenCV's windows).
    std::vector<std::uint8_t> bgr() const;

    /// Writes the finished picture through a temporary file and a rename.
    /// @throws InputError when the file cannot be written or its extension is not .png
    void save(const std::filesystem::path& path) const;

private:
    class Canvas;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace caustic
