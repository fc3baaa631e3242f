#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/process.h"
#include "image/image_file.h"
#include "scene/scene.h"
#include "scene_file.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

const std::string good = R"({
  "camera": {"position": [0, -4, 1], "target": [0, 0, 0], "fieldOfView": 30, "width": 24, "height": 16},
  "materials": {"white": {"type": "diffuse", "reflectance": 0.7}, "glass": {"type": "glass"}},
  "media": {"smoke": {"absorption": 0.1, "scattering": [0.2, 0.3, 0.4], "g": 0.5}},
  "objects": [
    {"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 0.5}, "material": "glass", "interior": {"ior": 1.5, "medium": "smoke"}},
    {"shape": {"type": "rectangle", "corner": [-1, -1, -0.6], "edgeU": [2, 0, 0], "edgeV": [0, 2, 0]}, "material": "white"}
  ],
  "lights": [{"type": "point", "position": [1, -1, 2], "intensity": [3, 2, 1]}],
  "render": {"method": {"type": "path", "segments": 6}, "passes": 2}
})";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

std::string written(const test::TemporaryFolder& folder, const std::string& text) {
    const std::string file = (folder / "own.json").string();
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

std::string complaint(const std::string& file) {
    try {
        loadScene(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SceneFile, ReadsWhatTheFileSays) {
    const test::TemporaryFolder folder;
    const SceneFile read = loadScene(written(folder, good));
    const Scene scene(read.description);
    EXPECT_EQ(read.description.objects.size(), 2U);
    EXPECT_EQ(read.description.objects[0].interior->ior, 1.5);
    EXPECT_NE(read.description.objects[0].interior->medium, nullptr);
    EXPECT_TRUE(scene.needs().scattering);
    EXPECT_EQ(scene.camera().width(), 24);
    EXPECT_EQ(read.method.type, "path");
    EXPECT_EQ(read.method.segments, 6);
    EXPECT_EQ(read.limits.passes, 2);
}

// The course's examples.
TEST(SceneFile, ReadsTheExamples) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::sourceDir() / "assets/scenes")) {
        EXPECT_NO_THROW(Scene(loadScene(entry.path().string()).description)) << entry.path();
        ++count;
    }
    EXPECT_EQ(count, 4);
}

struct Bad {
    std::string what;  ///< of the good file
    std::string by;
    std::string place;  ///< JSON pointer in the complaint
    std::string reason;
};

// Whatever is wrong is named by file, JSON pointer and reason.
TEST(SceneFile, NamesWhatIsWrongAndWhere) {
    const std::vector<Bad> all = {
        {"\"camera\"", "\"kamera\"", "#/kamera", "no such member"},
        {"\"fieldOfView\": 30, ", "", "#/camera", "needs a member \"fieldOfView\""},
        {"\"fieldOfView\": 30", "\"fieldOfView\": 0", "#/camera", "field of view"},
        {"\"fieldOfView\": 30", "\"fieldOfView\": 200", "#/camera/fieldOfView", "must be from 0 to 180"},
        {"\"fieldOfView\": 30", "\"fieldOfView\": \"wide\"", "#/camera/fieldOfView", "must be a number"},
        {"\"width\": 24", "\"width\": 0", "#/camera/width", "must be from 1 to"},
        {"\"width\": 24", "\"width\": 2.5", "#/camera/width", "whole number"},
        {"\"width\": 24, \"height\": 16", "\"width\": 90000, \"height\": 90000", "#/camera", ""},
        {"\"width\": 24", "\"width\": 24, \"hight\": 3", "#/camera/hight", "no such member"},
        {"\"height\": 16", "\"height\": 16, \"lens\": {\"radius\": -1, \"focus\": 2}", "#/camera/lens/radius",
         "at least 0"},
        {"\"height\": 16", "\"height\": 16, \"lens\": {\"radius\": 1, \"focus\": 0}", "#/camera", "focus"},
        {"\"height\": 16", "\"height\": 16, \"lens\": 3", "#/camera/lens", "must be an object"},
        {"[0, -4, 1]", "[0, -4]", "#/camera/position", "three numbers"},
        {"[0, -4, 1]", "[0, null, 1]", "#/camera/position/1", "must be a number"},
        {"[0, -4, 1]", "[0, 0, 0]", "#/camera", ""},
        {"\"type\": \"diffuse\"", "\"type\": \"difuse\"", "#/materials/white/type", "must be one of diffuse"},
        {"\"reflectance\": 0.7", "\"reflectance\": 1.7", "#/materials/white", "reflectance"},
        {"\"reflectance\": 0.7", "\"reflectance\": -0.7", "#/materials/white/reflectance", "at least 0"},
        {"\"reflectance\": 0.7", "\"reflectance\": {\"type\": \"image\", \"file\": \"none.png\"}", "none.png", ""},
        {"\"reflectance\": 0.7", "\"reflectance\": {\"type\": \"checker\", \"even\": 1, \"odd\": 0, \"side\": 0}",
         "#/materials/white/reflectance/side", "must be at least"},
        {"{\"type\": \"glass\"}", "{\"type\": \"glass\", \"roughness\": 2}", "#/materials/glass/roughness",
         "from 0 to 1"},
        {"{\"type\": \"glass\"}", "{\"type\": \"glass\", \"ior\": 2}", "#/materials/glass/ior", "no such member"},
        {"{\"type\": \"glass\"}", "[]", "#/materials/glass", "must be an object"},
        {"\"g\": 0.5", "\"g\": 1", "#/media/smoke", "mean cosine"},
        {"\"g\": 0.5", "\"g\": -3", "#/media/smoke/g", "from -1 to 1"},
        {"\"absorption\": 0.1", "\"absorption\": -0.1", "#/media/smoke/absorption", "at least 0"},
        {"\"radius\": 0.5", "\"radius\": 0", "#/objects/0/shape", "radius"},
        {"\"radius\": 0.5", "\"radius\": -2", "#/objects/0/shape/radius", "at least 0"},
        {"\"type\": \"sphere\"", "\"type\": \"ball\"", "#/objects/0/shape/type", "must be one of sphere, box"},
        {"\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.5", "\"type\": \"mesh\", \"file\": \"none.obj\"",
         "none.obj", ""},
        {"\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.5",
         "\"type\": \"revolution\", \"file\": \"none.svg\"", "none.svg", ""},
        {"\"material\": \"glass\"", "\"material\": \"glas\"", "#/objects/0/material", "there are glass, white"},
        {"\"medium\": \"smoke\"", "\"medium\": \"fog\"", "#/objects/0/interior/medium", "there are smoke"},
        {"\"ior\": 1.5", "\"ior\": 0", "#/objects/0/interior/ior", "must be from"},
        {", \"material\": \"white\"", "", "#/objects/1", "needs a material"},
        {"\"edgeV\": [0, 2, 0]", "\"edgeV\": [1, 2, 0]", "#/objects/1/shape", "perpendicular"},
        {"\"material\": \"white\"",
         "\"material\": \"white\", \"transform\": [{\"type\": \"scale\", \"by\": [1, 0, 1]}]",
         "#/objects/1/transform/0", ""},
        {"\"material\": \"white\"", "\"material\": \"white\", \"transform\": {}", "#/objects/1/transform",
         "must be a list"},
        {"\"material\": \"white\"",
         "\"material\": \"white\", \"transform\": [{\"type\": \"turn\", \"axis\": [0, 0, 0], \"degrees\": 9}]",
         "#/objects/1/transform/0", ""},
        {"\"material\": \"white\"", "\"emission\": [1, -1, 1]", "#/objects/1/emission/1", "at least 0"},
        {"\"material\": \"white\"", "\"material\": \"white\", \"normalMap\": {\"file\": \"none.png\"}", "none.png", ""},
        {"\"type\": \"point\"", "\"type\": \"sun\"", "#/lights/0/type", "must be one of point"},
        {"[3, 2, 1]", "[3, 2, 1, 0]", "#/lights/0/intensity", "three for red, green and blue"},
        {"[3, 2, 1]", "[3, 2, 1e999]", "own.json", "too large"},
        {"{\"type\": \"point\", \"position\": [1, -1, 2], \"intensity\": [3, 2, 1]}", "{\"type\": \"environment\"}",
         "#/lights/0", "either a radiance or a file"},
        {"\"type\": \"path\"", "\"type\": \"magic\"", "#/render/method/type", "must be one of path"},
        {"\"segments\": 6", "\"segments\": 0", "#/render/method/segments", "must be from 1"},
        {", \"passes\": 2", "", "#/render", "needs passes or seconds"},
        {"\"passes\": 2", "\"seconds\": 0", "#/render/seconds", "must be from"},
        {"\"passes\": 2", "\"passes\": 2, \"passes\": 3", "own.json", "two members of one name"},
        {"\"passes\": 2", "\"passes\": 2,", "own.json:", "is no JSON"},
        {"\"objects\": [", "\"objects\": {\"a\": [", "own.json:", "is no JSON"}};
    const test::TemporaryFolder folder;
    for (const Bad& bad : all) {
        const std::string file = written(folder, replaced(good, bad.what, bad.by));
        const std::string said = complaint(file);
        EXPECT_NE(said.find(bad.place), std::string::npos) << bad.by << "\n  " << said;
        EXPECT_NE(said.find(bad.reason), std::string::npos) << bad.by << "\n  " << said;
    }
    for (const char* const text : {"", "[]", "3", "null", "{\"camera\": 1}", "\xff\xfe", "{\"camera\": \"\\ud800\"}"})
        EXPECT_FALSE(complaint(written(folder, text)).empty()) << text;
    EXPECT_FALSE(complaint((folder / "missing.json").string()).empty());
    EXPECT_FALSE(complaint(folder.path().string()).empty());
    EXPECT_NE(complaint(written(folder, std::string(40, '[') + std::string(40, ']'))).find("nested"),
              std::string::npos);
}

// The command: a picture, the same for any number of threads; of a bad file nothing but one line and exit code 2.
TEST(SceneCommand, RendersOrComplains) {
    const test::TemporaryFolder folder;
    const std::string file = written(folder, good);
    for (const char* const method : {"path", "light", "bidirectional", "photons", "fog"}) {
        written(folder, replaced(replaced(good, "\"path\"", "\"" + std::string(method) + "\""), "\"segments\": 6",
                                 "\"segments\": 6, \"photons\": 500"));
        for (const char* const threads : {"1", "2"}) {
            const auto run = runProcess(
                {test::chapterProgram(), "--scene", file, "--out", (folder / threads).string(), "--threads", threads});
            ASSERT_EQ(run->exitCode, 0) << method << run->output;
        }
        const Image one = loadImage(folder / "1" / "11_effects/own.png");
        const Image two = loadImage(folder / "2" / "11_effects/own.png");
        Real sum = 0;
        for (int y = 0; y < one.height(); ++y) {
            for (int x = 0; x < one.width(); ++x) {
                ASSERT_TRUE((one.at(x, y) == two.at(x, y)).all()) << method;
                sum += one.at(x, y).sum();
            }
        }
        EXPECT_GT(sum, 1) << method << ": all black";
    }
    for (const std::string& text :
         {replaced(good, "\"width\": 24", "\"width\": -1"),
          replaced(good, "{\"type\": \"point\", \"position\": [1, -1, 2], \"intensity\": [3, 2, 1]}", "")}) {
        written(folder, text);
        const auto run = runProcess({test::chapterProgram(), "--scene", file, "--out", (folder / "none").string()});
        EXPECT_EQ(run->exitCode, 2) << run->output;
        EXPECT_FALSE(std::filesystem::exists(folder / "none"));
    }
}

}  // namespace
}  // namespace caustic
