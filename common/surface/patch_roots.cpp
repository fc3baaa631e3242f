#include "surface/patch_roots.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class PatchSearch {
public:
    PatchSearch(const BezierPatch& patch, const ShearedRay& sheared) : patch_(patch), ray_(sheared) {
        whole_.degreeU = patch.degreeU();
        whole_.degreeV = patch.degreeV();
        Real largest = 0;
        for (int i = 0; i <= patch.degreeU(); ++i) {
            for (int j = 0; j <= patch.degreeV(); ++j) {
                const Vec3 from = patch.controlPoint(i, j) - sheared.ray.origin;
                largest = std::max(largest, from.lpNorm<Eigen::Infinity>());
                whole_.point[index(i)][index(j)] = flattened(from);
            }
        }
        tolerance_ = 64 * unitRoundoff * (largest + sheared.ray.origin.lpNorm<Eigen::Infinity>());
    }

    std::vector<PatchRoot> run() {
        search(whole_, {}, 0);
        if (pieces_ >= most_) searchByLevels();
        return std::move(roots_);
    }

private:
    // A line that runs within the surface would be looked for without end.
    static constexpr int mostInDepth = 1000;
    static constexpr int mostByLevels = 4000;
    static constexpr int deepest = 120;

    struct Piece {
        PlaneNet net;
        PatchDomain domain;
    };

    // Where a line nearly runs in the surface, a search in depth comes to no end, and what it would find elsewhere is
    // lost. So all parts of a width are searched before narrower ones. Not at once: their copies make every ray a third
    // slower.
    void searchByLevels() {
        most_ = mostByLevels;
        pieces_ = 0;
        next_.emplace();
        search(whole_, {}, 0);
        for (int depth = 1; !next_->empty(); ++depth) {
            const std::vector<Piece> level = std::exchange(*next_, {});
            for (const Piece& piece : level) search(piece.net, piece.domain, depth);
        }
    }

    Vec2 flattened(const Vec3& from) const {
        const Real z = from[ray_.axis[2]];
        return {from[ray_.axis[0]] - ray_.shear.x() * z, from[ray_.axis[1]] - ray_.shear.y() * z};
    }

    void search(const PlaneNet& net, const PatchDomain& domain, int depth) {
        Vec2 least = net.point[0][0];
        Vec2 most = least;
        for (int i = 0; i <= net.degreeU; ++i) {
            for (int j = 0; j <= net.degreeV; ++j) {
                least = least.cwiseMin(net.point[index(i)][index(j)]);
                most = most.cwiseMax(net.point[index(i)][index(j)]);
            }
        }
        if (!(least.maxCoeff() <= tolerance_ && most.minCoeff() >= -tolerance_)) return;
        const PatchDomain left = clippedDomain(net, tolerance_);
        if (left.u.empty() || left.v.empty()) return;
        const Vec2 middle(middleOf(domain.u, left.u), middleOf(domain.v, left.v));
        if (isOneToOne(net) && addByNewton(middle, domain)) return;
        if (isTiny(domain.u) && isTiny(domain.v)) return addAtFold(domain);
        if ((most - least).maxCoeff() <= tolerance_ || depth >= deepest || ++pieces_ >= most_) {
            return addIfClose(middle);
        }
        halve(net, domain, left, depth);
    }

    // Here the map is folded over, and over so short a piece by a parabola.
    static bool isTiny(const Interval& side) { return side.upper - side.lower <= 0x1p-20; }

    // Newton's method from either side of a fold finds the zero on that side, if there is one.
    void addAtFold(const PatchDomain& domain) {
        for (const Real u : {domain.u.lower, domain.u.upper}) {
            for (const Real v : {domain.v.lower, domain.v.upper}) addByNewton({u, v}, domain);
        }
    }

    static Real middleOf(const Interval& domain, const Interval& part) {
        return domain.lower + (part.lower + part.upper) / 2 * (domain.upper - domain.lower);
    }

    void halve(const PlaneNet& net, const PatchDomain& domain, const PatchDomain& left, int depth) {
        PlaneNet first;
        PlaneNet second;
        PatchDomain firstDomain = domain;
        PatchDomain secondDomain = domain;
        const bool alongU = extentU(net) >= extentV(net);
        const Interval& wanted = alongU ? left.u : left.v;
        if (alongU) {
            halveU(net, first, second);
            firstDomain.u.upper = secondDomain.u.lower = (domain.u.lower + domain.u.upper) / 2;
        } else {
            halveV(net, first, second);
            firstDomain.v.upper = secondDomain.v.lower = (domain.v.lower + domain.v.upper) / 2;
        }
        if (wanted.lower <= Real(0.5)) goOn(first, firstDomain, depth + 1);
        if (wanted.upper >= Real(0.5)) goOn(second, secondDomain, depth + 1);
    }

    void goOn(const PlaneNet& net, const PatchDomain& domain, int depth) {
        if (next_) {
            next_->push_back({net, domain});
        } else {
            search(net, domain, depth);
        }
    }

    static Real extentU(const PlaneNet& net) {
        Real longest = 0;
        for (int j = 0; j <= net.degreeV; ++j) {
            Real length = 0;
            for (int i = 0; i < net.degreeU; ++i) {
                length += (net.point[index(i + 1)][index(j)] - net.point[index(i)][index(j)]).lpNorm<Eigen::Infinity>();
            }
            longest = std::max(longest, length);
        }
        return longest;
    }

    static Real extentV(const PlaneNet& net) {
        Real longest = 0;
        for (int i = 0; i <= net.degreeU; ++i) {
            Real length = 0;
            for (int j = 0; j < net.degreeV; ++j) {
                length += (net.point[index(i)][index(j + 1)] - net.point[index(i)][index(j)]).lpNorm<Eigen::Infinity>();
            }
            longest = std::max(longest, length);
        }
        return longest;
    }

    struct PlaneJet {
        Vec2 value;
        Vec2 du;
        Vec2 dv;
    };

    PlaneJet planeJet(const Vec2& uv) const {
        std::array<Vec2, PlaneNet::highestDegree + 1> point;
        std::array<Vec2, PlaneNet::highestDegree + 1> slope;
        for (int i = 0; i <= whole_.degreeU; ++i) {
            auto row = whole_.point[index(i)];
            for (int left = whole_.degreeV; left > 1; --left) {
                for (int j = 0; j < left; ++j) {
                    row[index(j)] = (1 - uv.y()) * row[index(j)] + uv.y() * row[index(j + 1)];
                }
            }
            point[index(i)] = (1 - uv.y()) * row[0] + uv.y() * row[1];
            slope[index(i)] = whole_.degreeV * (row[1] - row[0]);
        }
        for (int left = whole_.degreeU; left > 1; --left) {
            for (int i = 0; i < left; ++i) {
                point[index(i)] = (1 - uv.x()) * point[index(i)] + uv.x() * point[index(i + 1)];
                slope[index(i)] = (1 - uv.x()) * slope[index(i)] + uv.x() * slope[index(i + 1)];
            }
        }
        return {(1 - uv.x()) * point[0] + uv.x() * point[1], whole_.degreeU * (point[1] - point[0]),
                (1 - uv.x()) * slope[0] + uv.x() * slope[1]};
    }

    // Newton's method on the whole patch. False when it leaves the part, where at most one zero is: then the part is
    // free of zeros, or Newton went astray, and halving it will tell.
    bool addByNewton(Vec2 uv, const PatchDomain& domain) {
        constexpr Real slack = 1e-9;
        constexpr Real mostStray = 4;  // widths of the part
        constexpr int mostSteps = 12;
        for (int step = 0; step < mostSteps; ++step) {
            const PlaneJet jet = planeJet(uv);
            const Real determinant = crossOf(jet.du, jet.dv);
            const Vec2 move = -Vec2(crossOf(jet.value, jet.dv), crossOf(jet.du, jet.value)) / determinant;
            uv += move;
            if (!contains(domain, uv, mostStray)) return false;
            if (move.lpNorm<Eigen::Infinity>() <= 4 * unitRoundoff) break;
        }
        const Vec2 inside = uv.cwiseMax(0).cwiseMin(1);
        if (!contains(domain, inside, slack) || !isClose(inside)) return false;
        add(inside);
        return true;
    }

    static bool contains(const PatchDomain& domain, const Vec2& uv, Real slack) {
        const Real padU = slack * (domain.u.upper - domain.u.lower);
        const Real padV = slack * (domain.v.upper - domain.v.lower);
        return uv.x() >= domain.u.lower - padU && uv.x() <= domain.u.upper + padU && uv.y() >= domain.v.lower - padV &&
               uv.y() <= domain.v.upper + padV;
    }

    bool isClose(const Vec2& uv) const { return planeJet(uv).value.lpNorm<Eigen::Infinity>() <= tolerance_; }

    void addIfClose(const Vec2& uv) {
        if (isClose(uv)) add(uv);
    }

    // Parts that share a side may both find a root there.
    void add(const Vec2& uv) {
        const auto same = [&](const PatchRoot& root) { return (Vec2(root.u, root.v) - uv).norm() <= 1e-8; };
        if (std::any_of(roots_.begin(), roots_.end(), same)) return;
        const Vec3 from = patch_.evaluate(uv.x(), uv.y()).point - ray_.ray.origin;
        roots_.push_back({uv.x(), uv.y(), from.dot(ray_.ray.direction) / ray_.ray.direction.squaredNorm()});
    }

    const BezierPatch& patch_;
    const ShearedRay& ray_;
    PlaneNet whole_;
    Real tolerance_;
    int pieces_ = 0;
    int most_ = mostInDepth;
    std::optional<std::vector<Piece>> next_;  // by levels: the parts of the next one
    std::vector<PatchRoot> roots_;
};

}  // namespace

std::vector<PatchRoot> patchRoots(const BezierPatch& patch, const ShearedRay& sheared) {
    return PatchSearch(patch, sheared).run();
}

}  // namespace caustic
