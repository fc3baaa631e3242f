#include "failures/patch_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace caustic {

namespace {

using Long = long double;
using Point = std::array<Long, 3>;

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Long dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A part of the patch, and which of the four sides of the whole it touches.
struct Piece {
    std::array<std::array<Point, 10>, 10> point;
    bool touchesBorder[2][2];  // [u or v][low or high]
};

class PatchSubdivision {
public:
    PatchSubdivision(const BezierPatch& patch, const Ray& ray) : m_(patch.degreeU()), n_(patch.degreeV()) {
        Long size = 0;
        for (int i = 0; i <= m_; ++i) {
            for (int j = 0; j <= n_; ++j) {
                const Vec3& p = patch.controlPoint(i, j);
                at(whole_, i, j) = {p.x(), p.y(), p.z()};
                size = std::max(size, Long(p.lpNorm<Eigen::Infinity>()));
            }
        }
        whole_.touchesBorder[0][0] = whole_.touchesBorder[0][1] = true;
        whole_.touchesBorder[1][0] = whole_.touchesBorder[1][1] = true;
        origin_ = {ray.origin.x(), ray.origin.y(), ray.origin.z()};
        const Point d = {ray.direction.x(), ray.direction.y(), ray.direction.z()};
        length_ = std::sqrt(dot(d, d));
        direction_ = {d[0] / length_, d[1] / length_, d[2] / length_};
        // The rounding of double's own coordinates: nearer to its border than that, nobody can tell.
        pad_ = 2e-14L * (size + std::sqrt(dot(origin_, origin_)));
        size_ = size;
    }

    std::vector<ReferenceMeeting> run() {
        search(whole_, 0);
        return merged(std::move(found_), static_cast<Real>(1e-10L * size_ / length_));
    }

private:
    static constexpr int firstBandDepth = 20;
    static constexpr int deepest = 76;  // halvings of u and of v together
    static constexpr int mostPieces = 6000;

    static Point& at(Piece& piece, int i, int j) {
        return piece.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    static const Point& at(const Piece& piece, int i, int j) {
        return piece.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }

    // The least and the largest coordinate of a piece's control points.
    std::pair<Long, Long> side(const Piece& piece, std::size_t axis) const {
        Long least = HUGE_VALL;
        Long most = -HUGE_VALL;
        for (int i = 0; i <= m_; ++i) {
            for (int j = 0; j <= n_; ++j) {
                least = std::min(least, at(piece, i, j)[axis]);
                most = std::max(most, at(piece, i, j)[axis]);
            }
        }
        return {least, most};
    }

    // Where the line is in the box of the control points; low > high when nowhere.
    void window(const Piece& piece, Long& low, Long& high) const {
        low = -HUGE_VALL;
        high = HUGE_VALL;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            auto [least, most] = side(piece, axis);
            least -= pad_ + origin_[axis];
            most += pad_ - origin_[axis];
            if (direction_[axis] == 0) {
                if (least > 0 || most < 0) high = -HUGE_VALL;
                continue;
            }
            const Long a = least / direction_[axis];
            const Long b = most / direction_[axis];
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
        }
    }

    // Cosine between line and normal at the corners; the largest, and whether there is a normal everywhere.
    bool normalIsClear(const Piece& piece, Long& largest) const {
        largest = 0;
        for (const int i : {0, m_}) {
            for (const int j : {0, n_}) {
                const Point du = minus(at(piece, i == 0 ? 1 : m_, j), at(piece, i == 0 ? 0 : m_ - 1, j));
                const Point dv = minus(at(piece, i, j == 0 ? 1 : n_), at(piece, i, j == 0 ? 0 : n_ - 1));
                const Point normal = cross(du, dv);
                const Long length = std::sqrt(dot(normal, normal));
                if (!(length > 1e-9L * std::sqrt(dot(du, du) * dot(dv, dv)))) return false;
                largest = std::max(largest, std::abs(dot(normal, direction_)) / length);
            }
        }
        return true;
    }

    // The longest side of a piece's box.
    Long extent(const Piece& piece) const {
        Long longest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [least, most] = side(piece, axis);
            longest = std::max(longest, most - least);
        }
        return longest;
    }

    // A line that grazes meets the boxes of pieces beside the one that it meets: as far along the line as a box is
    // wide, divided by the cosine. They are one meeting.
    void search(const Piece& piece, int depth) {
        Long low = 0;
        Long high = 0;
        window(piece, low, high);
        if (low > high) return;
        Long cosine = 0;
        const bool clear = normalIsClear(piece, cosine);
        if (depth >= firstBandDepth && clear && cosine < Long(tangencyBand)) return add(low, high, true);
        if (++pieces_ > mostPieces) return add(low, high, true);
        if (depth >= deepest) {
            const bool border = piece.touchesBorder[0][0] || piece.touchesBorder[0][1] || piece.touchesBorder[1][0] ||
                                piece.touchesBorder[1][1];
            const Long blur = clear ? (extent(piece) + 2 * pad_) / cosine : 0;
            return add(low - blur, high + blur, border || !clear);
        }
        Piece first;
        Piece second;
        halve(piece, depth % 2, first, second);
        search(first, depth + 1);
        search(second, depth + 1);
    }

    void halve(const Piece& piece, int along, Piece& first, Piece& second) const {
        first = piece;
        second = piece;
        first.touchesBorder[along][1] = second.touchesBorder[along][0] = false;
        const int degree = along == 0 ? m_ : n_;
        const int others = along == 0 ? n_ : m_;
        for (int k = 0; k <= others; ++k) {
            const auto in = [&](Piece& of, int i) -> Point& { return along == 0 ? at(of, i, k) : at(of, k, i); };
            for (int i = 0; i <= degree; ++i) {
                in(first, i) = in(second, 0);
                for (int j = 0; j < degree - i; ++j) {
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        in(second, j)[axis] = (in(second, j)[axis] + in(second, j + 1)[axis]) / 2;
                    }
                }
            }
        }
    }

    void add(Long low, Long high, bool inBand) {
        found_.push_back({static_cast<Real>(low / length_), static_cast<Real>(high / length_), inBand});
    }

    int m_;
    int n_;
    Piece whole_;
    Point origin_;
    Point direction_;
    Long length_;
    Long pad_;
    Long size_;
    int pieces_ = 0;
    std::vector<ReferenceMeeting> found_;
};

Long bernsteinWeight(int n, int i, Long t) {
    Long weight = 1;
    for (int k = 0; k < i; ++k) weight *= t * (n - k) / (k + 1);
    for (int k = i; k < n; ++k) weight *= 1 - t;
    return weight;
}

}  // namespace

std::vector<ReferenceMeeting> meetingsBySubdivision(const BezierPatch& patch, const Ray& ray) {
    return PatchSubdivision(patch, ray).run();
}

Real distanceFromPatch(const BezierPatch& patch, Real u, Real v, const Vec3& point) {
    Point sum = {-Long(point.x()), -Long(point.y()), -Long(point.z())};
    for (int i = 0; i <= patch.degreeU(); ++i) {
        for (int j = 0; j <= patch.degreeV(); ++j) {
            const Long weight = bernsteinWeight(patch.degreeU(), i, u) * bernsteinWeight(patch.degreeV(), j, v);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sum[axis] += weight * patch.controlPoint(i, j)[static_cast<int>(axis)];
            }
        }
    }
    return static_cast<Real>(std::sqrt(dot(sum, sum)));
}

}  // namespace caustic
