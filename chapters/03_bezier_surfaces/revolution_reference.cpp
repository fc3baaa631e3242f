#include "revolution_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "long_polygon.h"

namespace caustic {

namespace {

using namespace reference;

class Subdivision {
public:
    Subdivision(const std::vector<BezierCurve>& profile, const Ray& ray) {
        for (const BezierCurve& curve : profile) segments_.push_back(polygonOf(curve));
        Long size = 0;
        for (const Polygon& polygon : segments_) {
            for (const Point& p : polygon) size = std::max({size, std::abs(p.x), std::abs(p.y)});
        }
        pad_ = size * 4e-15L;
        Long square = 0;
        for (int i = 0; i < 3; ++i) square += Long(ray.direction[i]) * Long(ray.direction[i]);
        line_.length = std::sqrt(square);
        for (std::size_t i = 0; i < 3; ++i) {
            line_.o[i] = ray.origin[static_cast<int>(i)];
            line_.d[i] = ray.direction[static_cast<int>(i)] / line_.length;
        }
        size_ = size;
    }

    std::vector<ReferenceMeeting> run() {
        for (segment_ = 0; segment_ < segments_.size(); ++segment_) {
            search(segments_[segment_], {-HUGE_VALL, HUGE_VALL}, 0, true, true);
        }
        return merged(std::move(found_), static_cast<Real>(1e-11L * size_ / line_.length));
    }

private:
    static constexpr int firstBandDepth = 10;
    static constexpr int deepest = 46;
    // A line that nearly runs within the surface touches pieces without end; what is open then counts as in the band.
    static constexpr int mostPieces = 20000;

    // Where the line is in the piece's ring, at most two windows.
    void windowsOf(const Polygon& piece, const Window& within, std::array<Window, 2>& windows, int& count) const {
        count = 0;
        Long xLow = piece[0].x, xHigh = xLow, yLow = piece[0].y, yHigh = yLow;
        for (const Point& p : piece) {
            xLow = std::min(xLow, p.x);
            xHigh = std::max(xHigh, p.x);
            yLow = std::min(yLow, p.y);
            yHigh = std::max(yHigh, p.y);
        }
        const Long outer = std::max(std::abs(xLow), std::abs(xHigh)) + pad_;
        const Long inner = (xLow > 0 ? xLow : xHigh < 0 ? -xHigh : 0) - pad_;
        Window slab = within;
        if (line_.d[1] == 0) {
            if (line_.o[1] < yLow - pad_ || line_.o[1] > yHigh + pad_) return;
        } else {
            const Long a = (yLow - pad_ - line_.o[1]) / line_.d[1];
            const Long b = (yHigh + pad_ - line_.o[1]) / line_.d[1];
            slab = {std::max(slab.low, std::min(a, b)), std::min(slab.high, std::max(a, b))};
        }
        const auto wall = insideCylinder(line_, outer);
        if (!wall) return;
        slab = {std::max(slab.low, wall->low), std::min(slab.high, wall->high)};
        if (slab.low > slab.high) return;
        const auto hole = inner > 0 ? insideCylinder(line_, inner) : std::nullopt;
        if (!hole) {
            windows[static_cast<std::size_t>(count++)] = slab;
            return;
        }
        if (slab.low <= hole->low)
            windows[static_cast<std::size_t>(count++)] = {slab.low, std::min(slab.high, hole->low)};
        if (slab.high >= hole->high)
            windows[static_cast<std::size_t>(count++)] = {std::max(slab.low, hole->high), slab.high};
    }

    // Cosine between the line and the normal, where the profile's way is given.
    std::optional<Long> cosine(Point way, Long x, Long t) const {
        const Long length = lengthOf(way.x, way.y);
        if (!(length > 0)) return std::nullopt;
        way = {way.x / length, way.y / length};
        const Long px = line_.o[0] + t * line_.d[0];
        const Long pz = line_.o[2] + t * line_.d[2];
        const Long distance = lengthOf(px, pz);
        if (distance <= 1e-12L * size_) {
            // At a smooth pole the normal is the axis; a cone's tip has none.
            if (std::abs(way.y) > 1e-9L) return std::nullopt;
            return line_.d[1];
        }
        const Long outward = (px * line_.d[0] + pz * line_.d[2]) / distance;
        const Long sign = x < 0 ? -1 : 1;
        return way.y * outward - sign * way.x * line_.d[1];
    }

    // The way of the whole piece, if it hardly turns.
    static std::optional<Point> wayOf(const Polygon& piece) {
        const Point chord = {piece.back().x - piece.front().x, piece.back().y - piece.front().y};
        for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
            const Point step = {piece[i + 1].x - piece[i].x, piece[i + 1].y - piece[i].y};
            const Long along = step.x * chord.x + step.y * chord.y;
            const Long across = step.x * chord.y - step.y * chord.x;
            if (!(along > 0) || std::abs(across) > along) return std::nullopt;
        }
        return chord;
    }

    void search(const Polygon& piece, const Window& within, int depth, bool first, bool last) {
        std::array<Window, 2> windows;
        int count = 0;
        windowsOf(piece, within, windows, count);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            if (!passesBeside(piece, windows[i])) follow(piece, windows[i], depth, first, last);
        }
    }

    // Whether the line stays on one side of the strip along the piece's chord that holds its control points. Across the
    // chord the line's distance from the axis makes a convex or a concave function: its tangent bounds it on one side,
    // its chord on the other.
    bool passesBeside(const Polygon& piece, const Window& window) const {
        const Point chord = {piece.back().x - piece.front().x, piece.back().y - piece.front().y};
        const Long length = lengthOf(chord.x, chord.y);
        if (!(length > 0)) return false;
        const Point normal = {chord.y / length, -chord.x / length};
        const Long sign = piece.front().x < 0 || piece.back().x < 0 ? -1 : 1;
        Long least = 0;
        Long most = 0;
        for (const Point& p : piece) {
            if (sign * p.x < 0) return false;
            const Long across = normal.x * (p.x - piece.front().x) + normal.y * (p.y - piece.front().y);
            least = std::min(least, across);
            most = std::max(most, across);
        }
        const auto acrossAt = [&](Long t) {
            const Long px = line_.o[0] + t * line_.d[0];
            const Long pz = line_.o[2] + t * line_.d[2];
            return normal.x * (sign * lengthOf(px, pz) - piece.front().x) +
                   normal.y * (line_.o[1] + t * line_.d[1] - piece.front().y);
        };
        const Long middle = (window.low + window.high) / 2;
        const Long half = (window.high - window.low) / 2;
        const Long px = line_.o[0] + middle * line_.d[0];
        const Long pz = line_.o[2] + middle * line_.d[2];
        const Long distance = lengthOf(px, pz);
        if (!(distance > 0)) return false;
        const Long slope = normal.x * sign * (px * line_.d[0] + pz * line_.d[2]) / distance + normal.y * line_.d[1];
        const Long low = acrossAt(window.low);
        const Long high = acrossAt(window.high);
        const Long atMiddle = acrossAt(middle);
        const bool convex = normal.x * sign > 0;
        const Long lineLeast = convex ? atMiddle - std::abs(slope) * half : std::min(low, high);
        const Long lineMost = convex ? std::max(low, high) : atMiddle + std::abs(slope) * half;
        return lineLeast > most + pad_ || lineMost < least - pad_;
    }

    void follow(const Polygon& piece, const Window& window, int depth, bool first, bool last) {
        if (depth >= firstBandDepth && isTangent(piece, window)) return add(window, true);
        if (++pieces_ > mostPieces) return add(window, true);
        if (depth == deepest) {
            const bool open = (first && !passes(true, window)) || (last && !passes(false, window));
            return add(window, open || !wayOf(piece));
        }
        Polygon left;
        Polygon right;
        halve(piece, left, right);
        search(left, window, depth + 1, first, false);
        search(right, window, depth + 1, false, last);
    }

    // Whether the line is tangent up to the band at both ends and in the middle of piece and window.
    bool isTangent(const Polygon& piece, const Window& window) const {
        const auto way = wayOf(piece);
        if (!way) return false;
        const std::size_t n = piece.size();
        const Point starting = {piece[1].x - piece[0].x, piece[1].y - piece[0].y};
        const Point arriving = {piece[n - 1].x - piece[n - 2].x, piece[n - 1].y - piece[n - 2].y};
        for (const Long t : {window.low, (window.low + window.high) / 2, window.high}) {
            for (const auto& [direction, x] :
                 {std::pair(starting, piece.front().x), std::pair(arriving, piece.back().x),
                  std::pair(*way, (piece.front().x + piece.back().x) / 2)}) {
                const auto c = cosine(direction, x, t);
                if (c && std::abs(*c) >= Long(tangencyBand)) return false;
            }
        }
        return true;
    }

    // The way along which a segment leaves its beginning or arrives at its end.
    static Point wayAtEnd(const Polygon& polygon, bool beginning) {
        const std::size_t n = polygon.size();
        for (std::size_t i = 1; i < n; ++i) {
            const Point& a = beginning ? polygon[0] : polygon[n - 1 - i];
            const Point& b = beginning ? polygon[i] : polygon[n - 1];
            if (a.x != b.x || a.y != b.y) return {b.x - a.x, b.y - a.y};
        }
        return {0, 0};
    }

    // Whether a line through this end of the segment passes from one side of the surface to the other.
    bool passes(bool beginning, const Window& window) const {
        const Polygon& here = segments_[segment_];
        const Point end = beginning ? here.front() : here.back();
        const Long t = (window.low + window.high) / 2;
        const auto mine = cosine(wayAtEnd(here, beginning), end.x, t);
        if (!mine) return false;
        if (end.x == 0) return true;
        for (const Polygon& other : segments_) {
            const Point& meets = beginning ? other.back() : other.front();
            if (meets.x != end.x || meets.y != end.y) continue;
            const auto theirs = cosine(wayAtEnd(other, !beginning), end.x, t);
            return theirs && *mine * *theirs > 0 && std::abs(*theirs) >= Long(tangencyBand);
        }
        return false;
    }

    void add(const Window& window, bool inBand) {
        found_.push_back(
            {static_cast<Real>(window.low / line_.length), static_cast<Real>(window.high / line_.length), inBand});
    }

    std::vector<Polygon> segments_;
    std::size_t segment_ = 0;
    Line line_;
    Long pad_;
    int pieces_ = 0;
    Long size_;
    std::vector<ReferenceMeeting> found_;
};

}  // namespace

std::vector<ReferenceMeeting> merged(std::vector<ReferenceMeeting> found, Real gap) {
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.tLow < b.tLow; });
    std::vector<ReferenceMeeting> meetings;
    for (const ReferenceMeeting& one : found) {
        if (meetings.empty() || one.tLow > meetings.back().tHigh + gap) {
            meetings.push_back(one);
            continue;
        }
        meetings.back().tHigh = std::max(meetings.back().tHigh, one.tHigh);
        meetings.back().inBand = meetings.back().inBand || one.inBand;
    }
    return meetings;
}

std::vector<ReferenceMeeting> meetingsBySubdivision(const std::vector<BezierCurve>& profile, const Ray& ray) {
    return Subdivision(profile, ray).run();
}

Real distanceFromRevolved(const BezierCurve& segment, Real u, const Vec3& point) {
    Polygon level = polygonOf(segment);
    for (std::size_t left = level.size(); left > 1; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) {
            level.point[i] = {level[i].x + Long(u) * (level[i + 1].x - level[i].x),
                              level[i].y + Long(u) * (level[i + 1].y - level[i].y)};
        }
    }
    const Long distance = std::hypot(Long(point.x()), Long(point.z()));
    return static_cast<Real>(std::hypot(distance - std::abs(level[0].x), Long(point.y()) - level[0].y));
}

}  // namespace caustic
