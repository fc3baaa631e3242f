#include "scene_shapes.h"

#include <numbers>

#include "curve/profile_file.h"
#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"
#include "scene_materials.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

namespace {

constexpr Real largest = JsonPlace::largest;

using ShapeKind = JsonKind<std::shared_ptr<const Shape>>;
using StepKind = JsonKind<Transform>;

const std::vector<ShapeKind>& shapeKinds() {
    static const std::vector<ShapeKind> kinds = {
        {"sphere",
         {"center", "radius"},
         [](const JsonPlace& place) {
             return std::make_shared<Sphere>(place["center"].vector(), place["radius"].number(0, largest));
         }},
        {"box",
         {"low", "high"},
         [](const JsonPlace& place) { return std::make_shared<Box>(place["low"].vector(), place["high"].vector()); }},
        {"plane",
         {"point", "normal"},
         [](const JsonPlace& place) {
             return std::make_shared<Plane>(place["point"].vector(), place["normal"].vector());
         }},
        {"rectangle",
         {"corner", "edgeU", "edgeV"},
         [](const JsonPlace& place) {
             return std::make_shared<Rectangle>(place["corner"].vector(), place["edgeU"].vector(),
                                                place["edgeV"].vector());
         }},
        {"ring",
         {"innerRadius", "outerRadius", "bottom", "top"},
         [](const JsonPlace& place) {
             return std::make_shared<RingCylinder>(
                 place["innerRadius"].number(0, largest), place["outerRadius"].number(0, largest),
                 place["bottom"].number(-largest, largest), place["top"].number(-largest, largest));
         }},
        {"mesh",
         {"file", "smooth"},
         [](const JsonPlace& place) {
             MeshData mesh = loadMesh(fileNamedBy(place["file"]));
             const auto smooth = place.find("smooth");
             if (smooth && smooth->choice({"yes", "no"}) == "yes") mesh = withVertexNormals(mesh, NormalWeight::Angle);
             return std::make_shared<TriangleMesh>(std::move(mesh));
         }},
        {"revolution", {"file"}, [](const JsonPlace& place) {
             return std::make_shared<SurfaceOfRevolution>(loadProfile(fileNamedBy(place["file"])));
         }}};
    return kinds;
}

const std::vector<StepKind>& stepKinds() {
    static const std::vector<StepKind> kinds = {
        {"move", {"by"}, [](const JsonPlace& place) { return Transform::translation(place["by"].vector()); }},
        {"scale",
         {"by"},
         [](const JsonPlace& place) {
             const JsonPlace by = place["by"];
             return Transform::scaling(by.isList() ? by.vector() : Vec3::Constant(by.number(-largest, largest)));
         }},
        {"turn", {"axis", "degrees"}, [](const JsonPlace& place) {
             return Transform::rotation(place["axis"].vector(),
                                        place["degrees"].number(-3600, 3600) * std::numbers::pi / 180);
         }}};
    return kinds;
}

}  // namespace

std::shared_ptr<const Shape> readShape(const JsonPlace& place) { return makeKind(place, shapeKinds()); }

std::shared_ptr<const Shape> moved(std::shared_ptr<const Shape> shape, const JsonPlace& steps) {
    Transform all;
    for (const JsonPlace& step : steps.items()) all = makeKind(step, stepKinds()) * all;
    return steps.make([&] { return std::make_shared<Instance>(std::move(shape), all); });
}

}  // namespace caustic
