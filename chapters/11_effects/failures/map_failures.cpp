#include "failures/map_failures.h"

#include <cmath>
#include <numbers>

#include "bare_normals.h"
#include "camera/thin_lens_camera.h"
#include "image/spherical_map.h"
#include "light/environment_map.h"
#include "material/directions.h"
#include "sampling/warp.h"
#include "texture/mapped_normal.h"
#include "texture/normal_map.h"

namespace caustic {

namespace {

// Each says whether the fragile method and the course's own are right.

Vec3 someDirection(Random& random) {
    const Real x = random.uniform();
    return uniformSphere({x, random.uniform()});
}

Hit someHit(Random& random) {
    Hit hit;
    hit.ng = someDirection(random);
    const Frame frame = Frame::around(hit.ng);
    hit.dpdu = random.uniform(0.1, 5) * frame.s;
    hit.dpdv = random.uniform(-5, 5) * frame.t + random.uniform(-1, 1) * frame.s;
    hit.ns = (hit.ng + 0.2 * someDirection(random)).normalized();
    return hit;
}

// A flat map of 8 bits leaves the normal as it was, to the last bit. Fragile: 2c/255 − 1, by which no code is 0.
std::vector<bool> flatMap(Random& random) {
    const Hit hit = someHit(random);
    const Vec3 wo = someDirection(random);
    const Vec3 byTheBook = (2 * Vec3(128, 128, 255) / 255 - Vec3::Ones()).normalized();
    const NormalMap map(decodedNormals(Image(1, 1, Color(128, 128, 255) / 255), PngDepth::Bits8));
    return {bareNormal(hit, byTheBook) == hit.ns, mappedNormal(hit, map.at({random.uniform(), 0.3}), wo) == hit.ns};
}

// A dent seen along the surface: what it mirrors lies above the surface.
std::vector<bool> grazingDent(Random& random) {
    Hit hit = someHit(random);
    hit.ns = hit.ng;
    const Real slope = random.uniform(0.05, 0.8);
    const Real angle = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 local = Vec3(slope * std::cos(angle), slope * std::sin(angle), 1).normalized();
    const Vec3 along = hit.ng.cross(someDirection(random)).normalized();
    const Vec3 wo = (std::pow(10, random.uniform(-4, -0.3)) * hit.ng + along).normalized();
    const auto above = [&](const Vec3& normal) { return reflected(wo, normal).dot(hit.ng) > 0; };
    return {above(bareNormal(hit, local)), above(mappedNormal(hit, local, wo))};
}

// What of a bilinear look-up has no density when pixels are picked whole: the half pixel around each bright one, at the
// seam and the poles as anywhere.
std::vector<bool> seamAndPoles(Random& random) {
    constexpr int height = 8;
    Image image(2 * height, height);
    const bool seam = random.below(2) == 0;
    const int row = seam ? static_cast<int>(random.below(height)) : (random.below(2) == 0 ? 0 : height - 1);
    image.set(seam ? 0 : static_cast<int>(random.below(2 * height)), row, Color(5, 3, 1));
    const EnvironmentMap map(image);
    // A direction beside the seam, or by a pole, that the look-up finds bright.
    for (;;) {
        const Vec2 place(seam ? random.uniform(-0.06, 0.06) : random.uniform(),
                         seam ? random.uniform() : (row == 0 ? random.uniform(0, 0.2) : random.uniform(0.8, 1)));
        const Vec3 wi = uvToSpherical(place);
        if (map.Le(Ray{Vec3::Zero(), wi}).x() <= 0.05) continue;
        const Vec2 uv = sphericalToUv(wi);
        const Color pixel = image.nearest(uv.x() * 2 * height, uv.y() * height, Wrap::Repeat, Wrap::Clamp);
        return {pixel.x() > 0, map.pdfW(Vec3::Zero(), wi) > 0};
    }
}

// A sun of one pixel in a map of 128 × 64: do 64 samples find it?
std::vector<bool> onePixelSun(Random& random) {
    Image image(128, 64, Color(0.1, 0.2, 0.4));
    image.set(static_cast<int>(random.below(128)), static_cast<int>(random.below(64)), Color::Constant(1e6));
    const EnvironmentMap map(image);
    bool even = false;
    bool bright = false;
    for (int i = 0; i < 64; ++i) {
        const Real x = random.uniform();
        const Vec2 u(x, random.uniform());
        even = even || map.Le(Ray{Vec3::Zero(), uniformSphere(u)}).x() > 1;
        bright = bright || map.sampleDirect({}, u)->radiance.x() > 1;
    }
    return {even, bright};
}

// Aperture 0: the pinhole's ray, to the last bit. Fragile: goes to the plane in focus as it would through a lens.
std::vector<bool> apertureZero(Random& random) {
    const Vec3 eye = 3 * someDirection(random);
    const Vec3 target = eye + someDirection(random);
    const Vec3 up(0.3, 0.2, 1);
    const Real focus = random.uniform(0.1, 20);
    const PinholeCamera pinhole(eye, target, up, 0.8, 40, 30);
    const ThinLensCamera lens(eye, target, up, 0.8, 40, 30, 0, focus);
    const Vec2 film(random.uniform(0, 40), random.uniform(0, 30));
    const Vec2 u(random.uniform(), random.uniform());
    const Ray expected = pinhole.sampleRay(film, u);
    const Vec3 inFocus = eye + expected.direction * (focus / expected.direction.dot((target - eye).normalized()));
    return {
        (inFocus - eye).normalized() == expected.direction,
        lens.sampleRay(film, u).direction == expected.direction && lens.sampleRay(film, u).origin == expected.origin};
}

}  // namespace

std::vector<FailureKind> mapKinds() {
    return {
        {"flat normal map: the same bits?", {{"2c/255 − 1"}, {"(c − 128)/127", true}}, flatMap},
        {"grazing dent: mirrors what is above?", {{"normals as they are"}, {"normals bent", true}}, grazingDent},
        {"seam and poles: has a bright place a density?",
         {{"whole pixels"}, {"cells between pixels", true}},
         seamAndPoles},
        {"one-pixel sun: found by 64 samples?", {{"even directions"}, {"by brightness", true}}, onePixelSun},
        {"aperture 0: the pinhole's bits?", {{"through the plane in focus"}, {"no lens asked", true}}, apertureZero}};
}

}  // namespace caustic
