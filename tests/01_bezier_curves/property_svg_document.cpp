#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "curve/svg_arc.h"
#include "curve/svg_document.h"
#include "support/paths.h"

namespace caustic {
namespace {

SvgTransform transformOf(const std::string& text) { return parseSvgTransform(text, {"test.svg", 1}); }

SvgDocument parse(const std::string& content) {
    return parseSvg("<svg xmlns='http://www.w3.org/2000/svg'>" + content + "</svg>", "test.svg");
}

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SvgDocument, TransformsOfAllGroupsAddUp) {
    const auto document = parse(
        "<g transform='translate(1 2)'><a><g transform='scale(3)'>"
        "<switch transform='rotate(90)'><svg x='5' y='7'><path transform='skewX(45)' d='M0 0'/></svg></switch>"
        "</g></a></g><path d='M0 0'/>");
    ASSERT_EQ(document.paths.size(), 2U);
    const SvgTransform expected = transformOf("translate(1 2) scale(3) rotate(90) translate(5 7) skewX(45)");
    EXPECT_LE((document.paths[0].transform.matrix() - expected.matrix()).norm(), 1e-13);
    EXPECT_EQ(document.paths[1].transform.matrix(), SvgTransform::Identity().matrix()) << "the groups have ended";
}

TEST(SvgDocument, WhatIsNotDrawnCanBeChosenByIdOnly) {
    const auto document = parse(
        "<defs><path id='inDefs' d='M0 0'/></defs><clipPath id='c'><path id='inClip' d='M0 0'/></clipPath>"
        "<symbol><g><path id='inSymbol' d='M0 0'/></g></symbol><path id='shown' d='M0 0'/>");
    EXPECT_EQ(document.paths.size(), 4U);
    EXPECT_EQ(chosenPath(document, "").id, "shown");
    EXPECT_EQ(chosenPath(document, "1").id, "shown");
    for (const char* id : {"inDefs", "inClip", "inSymbol"}) {
        EXPECT_EQ(chosenPath(document, id).id, id);
        EXPECT_FALSE(chosenPath(document, id).drawn);
    }
}

TEST(SvgDocument, NamespacesDecideWhatIsSvg) {
    const std::string prefixed =
        "<s:svg xmlns:s='http://www.w3.org/2000/svg' xmlns='urn:other'><path id='other'/><s:g><s:path id='svg'/>"
        "<s:path id='undone' xmlns:s='urn:other'/><path id='again' xmlns='http://www.w3.org/2000/svg'/></s:g></s:svg>";
    const auto document = parseSvg(prefixed, "test.svg");
    ASSERT_EQ(document.paths.size(), 2U);
    EXPECT_EQ(document.paths[0].id, "svg");
    EXPECT_EQ(document.paths[1].id, "again");
    EXPECT_EQ(parseSvg("<svg><path/></svg>", "test.svg").paths.size(), 1U) << "hand-made, without any namespace";
}

TEST(SvgDocument, LinesAreThoseOfTheFile) {
    const auto document = parseSvg(
        "<?xml version='1.0'?>\r\n<!-- a\nb -->\n<svg\n xmlns='http://www.w3.org/2000/svg'>\n<g\n>\n"
        "<path\n\n d='M0 0\n L1 1\n&#32;L2\n x'/>\n<path d=''/></g></svg>",
        "test.svg");
    ASSERT_EQ(document.paths.size(), 2U);
    EXPECT_EQ(document.paths[0].line, 8U);
    EXPECT_EQ(document.paths[0].dataPlace.line, 10U);
    EXPECT_EQ(document.paths[1].line, 14U);
    EXPECT_EQ(messageOf([&] { svgSplines(document.paths[0]); }).substr(0, 12), "test.svg:12:");
}

TEST(SvgDocument, ChoicesGoByIdThenByNumber) {
    const auto document = parse("<path id='2' d='M0 0'/><path id='b' d='M1 0'/><path d='M2 0'/>");
    EXPECT_EQ(chosenPath(document, "1").data, "M0 0");
    EXPECT_EQ(chosenPath(document, "2").data, "M0 0") << "an id goes before a number";
    EXPECT_EQ(chosenPath(document, "b").data, "M1 0");
    EXPECT_EQ(chosenPath(document, "3").data, "M2 0");
    EXPECT_EQ(messageOf([&] { chosenPath(document, ""); }), "test.svg: has several paths; choose one of #2, #b, #3");
}

TEST(SvgDocument, AFileWithoutPathsSaysWhatElseItDraws) {
    EXPECT_EQ(messageOf([] { chosenPath(parse("<rect/><g><circle/><rect/></g><defs><line/></defs>"), ""); }),
              "test.svg: draws no path; it draws 1 circle, 2 rect, to be converted to paths in the drawing program");
    EXPECT_EQ(messageOf([] { chosenPath(parse("<defs><path id='p'/></defs>"), ""); }),
              "test.svg: draws no path; not drawn, but may be chosen: #p");
    EXPECT_EQ(messageOf([] { chosenPath(parse(""), ""); }), "test.svg: draws no path");
}

TEST(SvgDocument, AListOfManyPathsIsCutShort) {
    std::string content;
    for (int i = 0; i < 1000; ++i) content += "<path id='path" + std::to_string(i) + "\n'/>";
    const std::string message = messageOf([&] { chosenPath(parse(content), "nothing"); });
    EXPECT_NE(message.find("#path19  and 980 more"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "an error is one line";
}

TEST(SvgDocument, WhatCantBeFollowedMakesAPathRefused) {
    const auto messageFor = [](const std::string& content) {
        return messageOf([&] { svgSplines(parse(content).paths.at(0)); });
    };
    const std::string path = "<path id='p' d='M0 0L1 1'/>";
    EXPECT_EQ(messageFor("<svg viewBox='0 0 1 1'>" + path + "</svg>"),
              "test.svg:1: path depends on a nested svg element with a viewBox, which is not followed here (got "
              "'p')");
    EXPECT_EQ(messageFor("<svg x='1mm'>" + path + "</svg>"),
              "test.svg:1: path depends on a nested svg element with x or y in units, which is not followed here "
              "(got 'p')");
    for (const char* harmless :
         {"text-transform:none;transform:none", "transform-origin:center", "translate:none",
          "/* transform:x */fill:red", "background:url(a;transform:rotate(3em))", "transform-box:fill-box"}) {
        EXPECT_EQ(messageFor("<g style='" + std::string(harmless) + "'>" + path + "</g>"), "no error") << harmless;
    }
    const auto expectNamed = [&](const std::string& content, const std::string& what) {
        EXPECT_EQ(messageFor(content),
                  "test.svg:1: path depends on " + what + ", which is not followed here (got 'p')");
    };
    const std::string turned = "<g transform='rotate(9)' ";
    expectNamed("<g style='transform:rotate3d(1,0,0,9deg)'>" + path + "</g>",
                "transform: rotate3d(1,0,0,9deg) in a style");
    expectNamed("<g style='translate:3px'>" + path + "</g>", "translate in a style");
    expectNamed("<g style='ROTATE : 3deg'>" + path + "</g>", "rotate in a style");
    expectNamed("<g style='scale: 2'>" + path + "</g>", "scale in a style");
    expectNamed("<path id='p' style='d:path(\"M0 0\")' d='M0 0L1 1'/>", "d in a style");
    expectNamed("<g style='offset-path:none;offset:path(\"M0 0\")'>" + path + "</g>", "offset in a style");
    expectNamed(turned + "transform-origin='center'>" + path + "</g>", "transform-origin: center");
    expectNamed(turned + "style='transform-origin:20 30'>" + path + "</g>", "transform-origin: 20 30");
    expectNamed(turned + "style='transform-box:fill-box'>" + path + "</g>", "transform-box: fill-box");
    expectNamed("<style>path { fill: red; TRANSFORM: scale(2) }</style>" + path, "transform in a style sheet");
    expectNamed(path + "<style><![CDATA[.a{display:none}]]></style>", "display in a style sheet");
    expectNamed(path + "<style>@import 'a.css';</style>", "@import in a style sheet");
    expectNamed("<g>" + path + "<animateTransform type='rotate'/></g>", "an animation (animateTransform)");
    expectNamed("<path id='p' d='M0 0L1 1'><animate attributeName='d'/></path>", "an animation (animate)");
    expectNamed("<switch><g systemLanguage='en'>" + path + "</g></switch>", "a language (systemLanguage)");
    expectNamed("<g style='display:contents'>" + path + "</g>", "display: contents");
    EXPECT_EQ(messageFor("<style>/* transform: x */ g { text-transform: none; fill: red }</style>" + path), "no error");
    EXPECT_EQ(messageFor("<animate attributeName='fill'/>" + path), "no error");
    const auto root = [](const std::string& before, const std::string& attributes) {
        return messageOf([&] {
            svgSplines(parseSvg(before + "<svg " + attributes + "><path id='p' d='M0 0'/></svg>", "t.svg").paths.at(0));
        });
    };
    EXPECT_EQ(
        root("", "transform='scale(2)'"),
        "t.svg:1: path depends on a transform of the outermost svg element, which is not followed here (got 'p')");
    EXPECT_EQ(root("<?xml-stylesheet href='a.css'?>", ""),
              "t.svg:1: path depends on a style sheet in another file, which is not followed here (got 'p')");
}

std::string drawnPaths(const std::string& content) {
    std::string ids;
    for (const SvgPathElement& path : parse(content).paths) ids += path.drawn ? path.id : "";
    return ids;
}

// SVG 2, 11.5 (visibility), 5.9 (switch); CSS Display 3 (none).
TEST(SvgDocument, DisplayAndVisibilityDecideWhatIsDrawn) {
    EXPECT_EQ(drawnPaths("<path id='a' display='none'/><path id='b' style='display : NONE !important; display:inline'/>"
                         "<path id='c' display='none' style='display:inline'/><path id='d'/>"),
              "cd")
        << "a style goes before an attribute";
    EXPECT_EQ(drawnPaths("<g display='none'><g display='inline' visibility='visible'><path id='a'/></g></g>"), "")
        << "nothing inside undoes display none";
    EXPECT_EQ(drawnPaths("<g visibility='hidden'><path id='a'/><path id='b' visibility='visible'/>"
                         "<g style='visibility:inherit'><path id='c'/><path id='d' style='visibility:visible'/></g></g>"
                         "<path id='e' style='visibility:collapse'/>"),
              "bd")
        << "visibility can be turned on again";
    EXPECT_EQ(
        drawnPaths("<a><g><path id='a'/></g></a><marker><path id='b'/></marker><pattern><path id='c'/></pattern>"),
        "a");
    EXPECT_EQ(drawnPaths("<switch><g requiredExtensions='urn:x'><path id='a'/></g><g><path id='b'/></g><path id='c'/>"
                         "</switch><path id='d' requiredExtensions=''/>"),
              "b")
        << "a switch draws one";
    EXPECT_EQ(messageOf([] { chosenPath(parse("<rect display='none'/><g visibility='hidden'><circle/></g>"), ""); }),
              "test.svg: draws no path");
}

TEST(SvgDocument, StylesTransformToo) {
    const auto expectMap = [](const std::string& attributes, const std::string& expected) {
        const auto path =
            parse("<g transform='translate(1 2)'><path d='M0 0L1 1' " + attributes + "/></g>").paths.at(0);
        const SvgTransform wanted = parseSvgTransform("translate(1 2)" + expected, {"test.svg", 1});
        EXPECT_LE((path.transform.matrix() - wanted.matrix()).norm(), 1e-13) << attributes;
    };
    expectMap("style='fill:none; transform : scale(2)'", "scale(2)");
    expectMap("style='transform:translate(1mm,2px)' transform='scale(9)'", "translate(3.7795275590551181 2)");
    expectMap("style='transform:none' transform='scale(9)'", "");
    expectMap("transform='rotate(90)' transform-origin='20 30'", "rotate(90 20 30)");
    expectMap("style='transform-origin:20px 30px;transform:rotate(90deg)' transform-origin='7 7'", "rotate(90 20 30)");
    expectMap("style='transform-origin:20px 30px' transform='scale(2)'", "translate(20 30)scale(2)translate(-20 -30)");
    expectMap("transform-origin='20 30'", "");
}

SvgPathElement field(const std::string& file, const std::string& id = "") {
    const auto path = test::sourceDir() / "tests/01_bezier_curves/field" / file;
    return chosenPath(parseSvg(readTextFile(path, 1 << 20), file), id);
}

BezierSpline fieldSpline(const std::string& file, const std::string& id = "") {
    const auto splines = svgSplines(field(file, id));
    EXPECT_EQ(splines.size(), 1U) << file;
    return splines.at(0);
}

// Files as drawing programs write them; what is right is known from what each draws.
TEST(SvgFromTheField, IsReadRight) {
    EXPECT_EQ(field("hidden_layer.svg").id, "vase");
    EXPECT_FALSE(field("hidden_layer.svg", "sketch").drawn);

    const BezierSpline turned = fieldSpline("transform_origin.svg");
    EXPECT_EQ(turned.segments().front().controlPoints().front(), Vec3(40, 30, 0));
    EXPECT_EQ(turned.segments().back().controlPoints().back(), Vec3(20, 30, 0));

    const Bounds3 arc = fieldSpline("arc_negative_radius.svg").bounds();
    EXPECT_NEAR(arc.min().y(), 10, 10 * arcError) << "a half circle whose top is at y = 10";
    EXPECT_NEAR(arc.max().y(), 20, 1e-12);

    const auto first = [](const char* id) {
        return fieldSpline("transform_fraction.svg", id).segments().front().controlPoints().front();
    };
    EXPECT_EQ(first("a"), Vec3(17, 17, 0));
    EXPECT_EQ(first("b"), Vec3(11.5, 10, 0));
    EXPECT_EQ(first("c"), Vec3(10.5, 12.25, 0));
    const Real c = std::cos(30.5 * std::numbers::pi / 180);
    const Real s = std::sin(30.5 * std::numbers::pi / 180);
    EXPECT_LE((first("d") - 10 * Vec3(c - s, c + s, 0)).norm(), 1e-13);
    EXPECT_LE((first("e") - Vec3(2.6458333, 2.6458333, 0)).norm(), 1e-14);
}

}  // namespace
}  // namespace caustic
