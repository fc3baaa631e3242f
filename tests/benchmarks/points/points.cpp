// The photon tree beside nanoflann: times of builds and queries, taken in turns by one thread, as a CSV table.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <nanoflann.hpp>

#include "accel/point_kd_tree.h"
#include "core/random.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "integrator/photon_tracer.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"

namespace caustic {
namespace {

// Points as nanoflann wants to ask for them.
template <typename Number>
struct Cloud {
    std::vector<std::array<Number, 3>> points;

    explicit Cloud(const std::vector<Vec3>& from) {
        for (const Vec3& point : from)
            points.push_back(
                {static_cast<Number>(point.x()), static_cast<Number>(point.y()), static_cast<Number>(point.z())});
    }
    std::size_t kdtree_get_point_count() const { return points.size(); }
    Number kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

template <typename Number>
using Peer = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<Number, Cloud<Number>>, Cloud<Number>, 3>;

struct Points {
    std::string name;
    std::vector<Vec3> points;
};

// Photons lie on surfaces, which is what the tree is made for.
Points photonsOfPeersBox(std::int64_t count) {
    const Scene scene(peersBox(16, 16));
    const IndependentSampler sampler(1);
    RayCounts counts;
    Points found = {"photons of the peers' box", {}};
    for (const Photon& photon : tracePhotons(scene, LightChoice(scene.lights()), sampler, {}, 0, count, 1, counts))
        found.points.push_back(photon.point);
    return found;
}

Points inCube(std::size_t count) {
    Random random(2, {});
    Points found = {"uniform in a cube", {}};
    for (std::size_t i = 0; i < count; ++i)
        found.points.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    return found;
}

// Median times of the four, in ns.
using Times = std::array<double, 3>;

Times buildTimes(const Points& all, int rounds) {
    const Cloud<float> floats(all.points);
    const Cloud<double> doubles(all.points);
    const std::vector<double> times = medianNanoseconds({[&] { keep(PointKdTree(all.points).size()); },
                                                         [&] {
                                                             Peer<float> tree(3, floats);
                                                             tree.buildIndex();
                                                             keep(tree);
                                                         },
                                                         [&] {
                                                             Peer<double> tree(3, doubles);
                                                             tree.buildIndex();
                                                             keep(tree);
                                                         }},
                                                        {rounds, 1e-3});
    return {times[0], times[1], times[2]};
}

// The trees of the same points, and queries that go round among some of them.
class Contest {
public:
    explicit Contest(const Points& all)
        : tree_(all.points), floats_(all.points), doubles_(all.points), ofFloats_(3, floats_), ofDoubles_(3, doubles_) {
        ofFloats_.buildIndex();
        ofDoubles_.buildIndex();
        Random random(3, {});
        for (int i = 0; i < 4096; ++i) {
            const Vec3 near = all.points[random.below(all.points.size())];
            queries_.push_back(near + 1e-3 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        }
    }

    Times nearest(std::size_t k, int rounds) {
        NearestPoints found;
        std::vector<std::uint32_t> index(k);
        std::vector<float> floats(k);
        std::vector<double> doubles(k);
        return timed(
            [&](const Vec3& at) {
                tree_.nearest(at, k, std::numeric_limits<Real>::infinity(), found);
                keep(found);
            },
            [&](const Vec3& at) {
                const Eigen::Vector3f query = at.cast<float>();
                keep(ofFloats_.knnSearch(query.data(), k, index.data(), floats.data()));
            },
            [&](const Vec3& at) { keep(ofDoubles_.knnSearch(at.data(), k, index.data(), doubles.data())); }, rounds);
    }

    Times within(Real radius, int rounds) {
        nanoflann::SearchParams unsorted;
        unsorted.sorted = false;
        std::vector<std::pair<std::uint32_t, float>> floats;
        std::vector<std::pair<std::uint32_t, double>> doubles;
        std::vector<NearPoint> found;
        return timed(
            [&](const Vec3& at) {
                found.clear();
                tree_.within(at, radius, [&found](const NearPoint& one) { found.push_back(one); });
                keep(found);
            },
            [&](const Vec3& at) {
                const Eigen::Vector3f query = at.cast<float>();
                keep(ofFloats_.radiusSearch(query.data(), static_cast<float>(radius * radius), floats, unsorted));
            },
            [&](const Vec3& at) { keep(ofDoubles_.radiusSearch(at.data(), radius * radius, doubles, unsorted)); },
            rounds);
    }

    // The radius within which so many points are, on average.
    Real usualRadius(std::size_t k) const {
        NearestPoints found;
        Real sum = 0;
        for (const Vec3& query : queries_) {
            tree_.nearest(query, k, std::numeric_limits<Real>::infinity(), found);
            sum += std::sqrt(found.points().front().squaredDistance);
        }
        return sum / static_cast<Real>(queries_.size());
    }

    // How often the k-th distance differs from nanoflann's in double.
    int differences(std::size_t k) {
        NearestPoints found;
        std::vector<std::uint32_t> index(k);
        std::vector<double> squared(k);
        int different = 0;
        for (const Vec3& query : queries_) {
            tree_.nearest(query, k, std::numeric_limits<Real>::infinity(), found);
            ofDoubles_.knnSearch(query.data(), k, index.data(), squared.data());
            different += std::abs(found.points().front().squaredDistance / squared.back() - 1) > 1e-12;
        }
        return different;
    }

    std::size_t memory() const { return tree_.memory(); }

private:
    template <typename Own, typename Floats, typename Doubles>
    Times timed(const Own& own, const Floats& floats, const Doubles& doubles, int rounds) {
        const auto round = [this](const auto& ask) {
            return [this, &ask, next = std::size_t{0}]() mutable {
                ask(queries_[next]);
                next = (next + 1) % queries_.size();
            };
        };
        const std::vector<double> times =
            medianNanoseconds({round(own), round(floats), round(doubles)}, {rounds, 2e-2});
        return {times[0], times[1], times[2]};
    }

    PointKdTree tree_;
    Cloud<float> floats_;
    Cloud<double> doubles_;
    Peer<float> ofFloats_;
    Peer<double> ofDoubles_;
    std::vector<Vec3> queries_;
};

void addRow(CsvTable& table, const std::string& points, const std::string& what, const Times& times, int differences) {
    const double ratio = times[1] / times[0];
    table.addRow(points, what, times[0], times[1], times[2], ratio, times[2] / times[0], differences);
    std::printf("%-28s %-16s %12.0f ns, %.2f times as fast as nanoflann in float, %.2f in double\n", points.c_str(),
                what.c_str(), times[0], ratio, times[2] / times[0]);
}

void run(const std::string& file, std::int64_t photons, int rounds) {
    CsvTable table({"points", "what", "tree_ns", "nanoflann_float_ns", "nanoflann_double_ns", "ratio_float",
                    "ratio_double", "differences"});
    const Points lying = photonsOfPeersBox(photons);
    for (const Points& all : {lying, inCube(lying.points.size())}) {
        const std::string name = all.name + ", " + std::to_string(all.points.size());
        addRow(table, name, "build", buildTimes(all, std::max(3, rounds / 3)), 0);
        Contest contest(all);
        for (const std::size_t k : {1, 8, 50, 200})
            addRow(table, name, "nearest " + std::to_string(k), contest.nearest(k, rounds), contest.differences(k));
        addRow(table, name, "within, of 50", contest.within(contest.usualRadius(50), rounds), 0);
    }
    table.save(file);
}

}  // namespace
}  // namespace caustic

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: bench_points TABLE PHOTONS ROUNDS\n");
        return 2;
    }
    try {
        caustic::run(argv[1], std::stoll(argv[2]), std::stoi(argv[3]));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "points: %s\n", error.what());
        return 1;
    }
    return 0;
}
