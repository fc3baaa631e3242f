#include "scene_materials.h"

#include <filesystem>

#include "image/image_file.h"
#include "material/conductor_material.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_material.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"
#include "texture/image_texture.h"

namespace caustic {

namespace {

constexpr Real largest = JsonPlace::largest;

using MaterialKind = JsonKind<std::shared_ptr<const Material>>;
using TextureKind = JsonKind<std::shared_ptr<const Texture>>;

Lookup lookupOf(const JsonPlace& place) {
    const auto lookup = place.find("lookup");
    return lookup && lookup->choice({"nearest", "bilinear"}) == "nearest" ? Lookup::Nearest : Lookup::Bilinear;
}

Vec2 tilesOf(const JsonPlace& place) {
    const auto tiles = place.find("tiles");
    if (!tiles) return Vec2::Ones();
    const std::vector<JsonPlace> both = tiles->items();
    if (both.size() != 2) tiles->refuse("must be two numbers, of u and of v");
    return {both[0].number(1e-9, 1e9), both[1].number(1e-9, 1e9)};
}

Metal metalOf(const JsonPlace& place) {
    const std::string name = place.choice({"gold", "silver", "copper"});
    return name == "gold" ? Metal::gold() : name == "silver" ? Metal::silver() : Metal::copper();
}

const std::vector<TextureKind>& textureKinds() {
    static const std::vector<TextureKind> kinds = {
        {"checker",
         {"even", "odd", "side"},
         [](const JsonPlace& place) {
             return std::make_shared<CheckerTexture>(place["even"].color(), place["odd"].color(),
                                                     place["side"].number(1e-12, largest));
         }},
        {"image", {"file", "lookup", "tiles"}, [](const JsonPlace& place) {
             const auto image = std::make_shared<Image>(loadImage(fileNamedBy(place["file"])));
             return std::make_shared<ImageTexture>(image, lookupOf(place), Wrap::Repeat, tilesOf(place));
         }}};
    return kinds;
}

const std::vector<MaterialKind>& materialKinds() {
    static const std::vector<MaterialKind> kinds = {
        {"diffuse",
         {"reflectance"},
         [](const JsonPlace& place) { return std::make_shared<DiffuseMaterial>(readTexture(place["reflectance"])); }},
        {"phong",
         {"diffuse", "specular", "exponent"},
         [](const JsonPlace& place) {
             return std::make_shared<PhongMaterial>(readTexture(place["diffuse"]), place["specular"].color(),
                                                    place["exponent"].number(0, largest));
         }},
        {"mirror",
         {"reflectance"},
         [](const JsonPlace& place) { return std::make_shared<MirrorMaterial>(place["reflectance"].color()); }},
        {"metal",
         {"metal", "roughness"},
         [](const JsonPlace& place) -> std::shared_ptr<const Material> {
             const Metal metal = metalOf(place["metal"]);
             const auto roughness = place.find("roughness");
             if (!roughness) return std::make_shared<ConductorMaterial>(metal);
             const Real alpha = roughness->number(0, 1);
             return std::make_shared<RoughConductorMaterial>(metal, alpha, alpha);
         }},
        {"glass", {"roughness"}, [](const JsonPlace& place) -> std::shared_ptr<const Material> {
             const auto roughness = place.find("roughness");
             if (!roughness) return std::make_shared<DielectricMaterial>();
             const Real alpha = roughness->number(0, 1);
             return std::make_shared<RoughDielectricMaterial>(alpha, alpha);
         }}};
    return kinds;
}

}  // namespace

std::string fileNamedBy(const JsonPlace& place) {
    return (std::filesystem::path(place.file()).parent_path() / place.text()).string();
}

std::shared_ptr<const Texture> readTexture(const JsonPlace& place) {
    if (place.isObject()) return makeKind(place, textureKinds());
    return place.make([&] { return std::make_shared<ConstantTexture>(place.color()); });
}

std::shared_ptr<const Material> readMaterial(const JsonPlace& place) { return makeKind(place, materialKinds()); }

std::shared_ptr<const Medium> readMedium(const JsonPlace& place) {
    place.allow({"absorption", "scattering", "g"});
    const auto coefficient = [&](const char* member) -> Color {
        const auto found = place.find(member);
        return found ? found->color() : Color::Zero();
    };
    const auto g = place.find("g");
    return place.make([&] {
        return std::make_shared<HomogeneousMedium>(coefficient("absorption"), coefficient("scattering"),
                                                   std::make_shared<HenyeyGreenstein>(g ? g->number(-1, 1) : 0));
    });
}

std::shared_ptr<const NormalMap> readNormalMap(const JsonPlace& place) {
    place.allow({"file", "lookup", "tiles"});
    return place.make([&] {
        const Image codes = loadImage(fileNamedBy(place["file"]), Encoding::Linear);
        return std::make_shared<NormalMap>(decodedNormals(codes, PngDepth::Bits8), lookupOf(place), tilesOf(place));
    });
}

}  // namespace caustic
