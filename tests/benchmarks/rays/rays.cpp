// Rays a second of each of our trees beside Embree's, one thread, in one process. ./course bench rays runs it.

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/text.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "math/frame.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_tree.h"

namespace caustic {
namespace {

double secondsOfThisThread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The float next to zero. By its bits: GCC 12 makes x of static_cast<Real>(static_cast<float>(x)) in a loop that it
// vectorises.
Vec3 rounded(const Vec3& v) {
    return v.unaryExpr(
        [](Real x) { return std::bit_cast<Real>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x1fffffff}); });
}

// The mesh in a unit ball inside a closed box of 12 triangles, so that every ray hits. All in floats: both sides get
// the same numbers.
MeshData scene(const std::string& file) {
    MeshData mesh = loadMesh(file);
    mesh.normals.clear();
    mesh.normalCorners.clear();
    mesh.uvs.clear();
    mesh.uvCorners.clear();
    Bounds3 box;
    for (const Vec3& position : mesh.positions) box.extend(position);
    Real radius = 0;
    for (const Vec3& position : mesh.positions) radius = std::max(radius, (position - box.center()).norm());
    for (Vec3& position : mesh.positions) position = rounded((position - box.center()) / radius);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < 8; ++i) mesh.positions.push_back(1.5 * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces = {
        {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
    for (const auto& [a, b, c, d] : faces) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.triangles.push_back({first + a, first + c, first + d});
    }
    return mesh;
}

// Counts what Embree asks of the system.
bool countBytes(void* total, ssize_t bytes, bool) {
    *static_cast<ssize_t*>(total) += bytes;
    return true;
}

// Embree's scene, built anew; deletes itself.
class EmbreeScene {
public:
    EmbreeScene(RTCDevice device, const MeshData& mesh) : scene_(rtcNewScene(device)) {
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
        for (const Vec3& position : mesh.positions) {
            for (const Real coordinate : position) *vertices++ = static_cast<float>(coordinate);
        }
        auto* corners = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t corner : triangle) *corners++ = corner;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        const double start = secondsOfThisThread();
        rtcCommitScene(scene_);
        buildSeconds = secondsOfThisThread() - start;
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;
    ~EmbreeScene() { rtcReleaseScene(scene_); }

    bool intersect(const RTCRay& ray, RTCRayHit& hit) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        hit.ray = ray;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &hit);
        return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

    bool occluded(RTCRay ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &ray);
        return ray.tfar < 0;
    }

    double buildSeconds = 0;

private:
    RTCScene scene_;
};

struct RaySet {
    std::string name;
    bool any;  // whether any hit will do
    std::vector<Ray> ours;
    std::vector<RTCRay> theirs;

    void add(const Vec3& origin, const Vec3& direction, Real tMax) {
        const Ray ray = {rounded(origin), rounded(direction), 0, static_cast<Real>(static_cast<float>(tMax))};
        ours.push_back(ray);
        RTCRay other{};
        other.org_x = static_cast<float>(ray.origin.x());
        other.org_y = static_cast<float>(ray.origin.y());
        other.org_z = static_cast<float>(ray.origin.z());
        other.dir_x = static_cast<float>(ray.direction.x());
        other.dir_y = static_cast<float>(ray.direction.y());
        other.dir_z = static_cast<float>(ray.direction.z());
        other.tfar = static_cast<float>(ray.tMax);
        other.mask = 0xffffffffU;
        theirs.push_back(other);
    }
};

Vec3 onSphere(Random& random) {
    const Real z = random.uniform(-1, 1);
    const Real angle = random.uniform(0, 2 * 3.141592653589793);
    const Real across = std::sqrt(1 - z * z);
    return {across * std::cos(angle), across * std::sin(angle), z};
}

constexpr Real offset = 1e-5;  // what a float ray needs here; ours would do with 1e-12

// From where each ray of a set hits, about the normal by its cosine.
void addBounces(const MeshTree& tree, const MeshData& mesh, const RaySet& from, std::uint64_t seed, RaySet& to) {
    for (std::size_t i = 0; i < from.ours.size(); ++i) {
        const Ray& ray = from.ours[i];
        const auto hit = tree.intersect(ray);
        if (!hit) continue;
        Vec3 normal = twiceArea(mesh, hit->triangle).normalized();
        if (normal.dot(ray.direction) > 0) normal = -normal;
        Random random(seed, {i});
        to.add(ray.at(hit->t) + offset * normal, (1.0001 * normal + onSphere(random)).normalized(), 1e30);
    }
}

std::vector<RaySet> raySets(const MeshTree& tree, const MeshData& mesh, int side) {
    std::vector<RaySet> sets = {{"primary", false, {}, {}},       {"diffuse bounce", false, {}, {}},
                                {"second bounce", false, {}, {}}, {"random chords", false, {}, {}},
                                {"shadow", true, {}, {}},         {"ambient occlusion", true, {}, {}}};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Vec3 direction((x + 0.5) / side * 2 - 1, 1 - (y + 0.5) / side * 2, -1.2);
            sets[0].add(Vec3(0.3, 0.4, 1.45), direction.normalized(), 1e30);
        }
    }
    addBounces(tree, mesh, sets[0], 1, sets[1]);
    addBounces(tree, mesh, sets[1], 2, sets[2]);
    for (std::size_t i = sets[2].ours.size() - 1; i > 0; --i) {
        const std::size_t other = Random(3, {i}).below(i + 1);
        std::swap(sets[2].ours[i], sets[2].ours[other]);
        std::swap(sets[2].theirs[i], sets[2].theirs[other]);
    }
    for (int i = 0; i < side * side; ++i) {
        Random random(4, {static_cast<std::uint64_t>(i)});
        const Vec3 from = 1.2 * onSphere(random);
        sets[3].add(from, (1.2 * onSphere(random) - from).normalized(), 1e30);
    }
    const Vec3 lamp(0.9, 1.2, 0.7);
    for (const Ray& ray : sets[1].ours) {
        const Vec3 way = lamp - ray.origin;
        sets[4].add(ray.origin, way.normalized(), 0.999 * way.norm());
        sets[5].add(ray.origin, ray.direction, 0.3);
    }
    return sets;
}

double secondsOf(const MeshTree& tree, const RaySet& set) {
    const double start = secondsOfThisThread();
    for (const Ray& ray : set.ours) {
        if (set.any) {
            keep(tree.occluded(ray));
        } else {
            keep(tree.intersect(ray));
        }
    }
    return secondsOfThisThread() - start;
}

double secondsOf(const EmbreeScene& scene, const RaySet& set) {
    const double start = secondsOfThisThread();
    RTCRayHit hit{};
    for (const RTCRay& ray : set.theirs) {
        if (set.any) {
            keep(scene.occluded(ray));
        } else {
            keep(scene.intersect(ray, hit));
        }
    }
    return secondsOfThisThread() - start;
}

// Rays whose hits differ: one misses, or t is off by more than 1e-5 of the scene. For any-hit rays, a different answer.
std::size_t differences(const MeshTree& tree, const EmbreeScene& scene, const RaySet& set) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < set.ours.size(); ++i) {
        if (set.any) {
            count += tree.occluded(set.ours[i]) != scene.occluded(set.theirs[i]) ? 1U : 0U;
            continue;
        }
        RTCRayHit hit{};
        const bool theirs = scene.intersect(set.theirs[i], hit);
        const auto ours = tree.intersect(set.ours[i]);
        const bool same = theirs == ours.has_value() && (!theirs || std::abs(ours->t - Real{hit.ray.tfar}) <= 1e-5);
        count += same ? 0U : 1U;
    }
    return count;
}

void measure(const std::string& name, const std::string& file, int side, int rounds, CsvTable& table) {
    const auto mesh = std::make_shared<const MeshData>(scene(file));
    const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device(rtcNewDevice("threads=1,set_affinity=0"),
                                                                   rtcReleaseDevice);
    ssize_t embreeBytes = 0;
    rtcSetDeviceMemoryMonitorFunction(device.get(), countBytes, &embreeBytes);
    double embreeBuild = 1e30;
    for (int i = 0; i < rounds; ++i) embreeBuild = std::min(embreeBuild, EmbreeScene(device.get(), *mesh).buildSeconds);
    const ssize_t before = embreeBytes;
    const EmbreeScene embree(device.get(), *mesh);
    // Without the arrays of vertices and corners: ours don't count those of the mesh either.
    const auto arrays = static_cast<ssize_t>(12 * (mesh->positions.size() + mesh->triangles.size()));
    embreeBytes -= before + arrays;

    constexpr std::array kinds = {MeshTreeKind::MedianKdTree, MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree,
                                  MeshTreeKind::WideBvh};
    const auto sets = raySets(*plantMeshTree(MeshTreeKind::WideBvh, mesh), *mesh, side);
    for (const MeshTreeKind kind : kinds) {
        const bool wide = kind == MeshTreeKind::WideBvh || kind == MeshTreeKind::WideKdTree;
        double build = 1e30;
        std::unique_ptr<const MeshTree> tree;
        for (int i = 0; i < (wide ? std::min(rounds, 3) : 1); ++i) {
            tree.reset();
            const double start = secondsOfThisThread();
            tree = plantMeshTree(kind, mesh);
            build = std::min(build, secondsOfThisThread() - start);
        }
        const MeshTreeSize size = tree->size();
        double logs = 0;
        for (const RaySet& set : sets) {
            double ours = 1e30;
            double theirs = 1e30;
            for (int i = 0; i < rounds; ++i) {
                theirs = std::min(theirs, secondsOf(embree, set));
                ours = std::min(ours, secondsOf(*tree, set));
            }
            logs += std::log(theirs / ours);
            const auto rays = static_cast<double>(set.ours.size());
            table.addRow(name, mesh->triangles.size(), caustic::name(kind), set.name, set.ours.size(),
                         1e-6 * rays / ours, 1e-6 * rays / theirs, theirs / ours, differences(*tree, embree, set),
                         build, build / embreeBuild,
                         static_cast<double>(size.bytes) / static_cast<double>(mesh->triangles.size()),
                         static_cast<double>(embreeBytes) / static_cast<double>(mesh->triangles.size()),
                         static_cast<double>(size.references) / static_cast<double>(mesh->triangles.size()));
        }
        std::printf("%s, %s: %.3f of Embree's rays a second (geometric mean), build %.2f times as long\n", name.c_str(),
                    caustic::name(kind).c_str(), std::exp(logs / static_cast<double>(sets.size())),
                    build / embreeBuild);
        std::fflush(stdout);
    }
}

template <typename Structure>
void shoot(const Structure& structure, const std::vector<RaySet>& sets, int rounds) {
    for (int i = 0; i < rounds; ++i) {
        for (const RaySet& set : sets) keep(secondsOf(structure, set));
    }
}

// Shoots all sets so many times at one structure, for whoever counts instructions.
void shootAt(const std::string& structure, const std::string& file, int side, int rounds) {
    const auto mesh = std::make_shared<const MeshData>(scene(file));
    const auto sets = raySets(*plantMeshTree(MeshTreeKind::WideBvh, mesh), *mesh, side);
    for (const MeshTreeKind kind : {MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree, MeshTreeKind::WideBvh}) {
        if (structure == name(kind)) return shoot(*plantMeshTree(kind, mesh), sets, rounds);
    }
    const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device(rtcNewDevice("threads=1,set_affinity=0"),
                                                                   rtcReleaseDevice);
    shoot(EmbreeScene(device.get(), *mesh), sets, rounds);
}

}  // namespace
}  // namespace caustic

// rays OUT.csv SIDE ROUNDS (NAME FILE)...
// rays --shoot STRUCTURE SIDE ROUNDS FILE
int main(int argc, char** argv) {
    using namespace caustic;
    try {
        const std::vector<std::string> words(argv + 1, argv + argc);
        if (words.at(0) == "--shoot") {
            shootAt(words.at(1), words.at(4), static_cast<int>(parseInteger(words.at(2)).value()),
                    static_cast<int>(parseInteger(words.at(3)).value()));
            return 0;
        }
        CsvTable table({"mesh", "triangles", "structure", "rays", "count", "megarays_per_second",
                        "embree_megarays_per_second", "ratio", "differences", "build_seconds", "build_ratio",
                        "bytes_per_triangle", "embree_bytes_per_triangle", "references_per_triangle"});
        const int side = static_cast<int>(parseInteger(words.at(1)).value());
        const int rounds = static_cast<int>(parseInteger(words.at(2)).value());
        for (std::size_t i = 3; i + 1 < words.size(); i += 2) measure(words[i], words[i + 1], side, rounds, table);
        table.save(words.at(0));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rays: %s\n", error.what());
        return 1;
    }
}
