#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "core/error.h"
#include "core/random.h"
#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_document.h"

namespace caustic {
namespace {

namespace fs = std::filesystem;

std::string messageOf(const std::string& text) {
    try {
        for (const SvgPathElement& path : parseSvg(text, "bad.svg").paths) svgSplines(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string withData(const std::string& data) { return messageOf("<svg><path d='" + data + "'/></svg>"); }

std::string withTransform(const std::string& transform) {
    return messageOf("<svg>\n<g transform='" + transform + "'><path d='M0 0L1 1'/></g></svg>");
}

TEST(BadPathData, IsRefusedFromTheFirstMistakeOn) {
    const std::string expected =
        "bad.svg:1: malformed path data from here on; a command M L H V C S Q T A Z with its numbers is expected";
    EXPECT_EQ(withData("M0 0 L1 1 L 2 x L3 3"), expected + " (got 'L 2 x L3 3')");
    EXPECT_EQ(withData("M0 0 L1 1 2"), expected + " (got '2')");
    EXPECT_EQ(withData("M0 0 C1 1 2 2 3"), expected + " (got 'C1 1 2 2 3')");
    EXPECT_EQ(withData("M0 0 X1 1"), expected + " (got 'X1 1')");
    EXPECT_EQ(withData("M0 0 L1,,1"), expected + " (got 'L1,,1')");
    EXPECT_EQ(withData("M0 0 L1 nan"), expected + " (got 'L1 nan')");
    EXPECT_EQ(withData("M0 0 L1 inf"), expected + " (got 'L1 inf')");
    EXPECT_EQ(withData("M0 0 L1 1e400"), expected + " (got 'L1 1e400')");
    EXPECT_EQ(withData("M0 0 L1 1e99999999999999999999"), expected + " (got 'L1 1e99999999999999999999')");
    EXPECT_EQ(withData("M0 0 A1 1 0 2 0 5 5"), expected + " (got 'A1 1 0 2 0 5 5')");
    EXPECT_EQ(withData("M0 0 z 5"), expected + " (got '5')");
    EXPECT_EQ(withData("M0 0 L1 1;"), expected + " (got ';')");
    EXPECT_EQ(withData("L1 1"), "bad.svg:1: path data must begin with M or m (got 'L1 1')");
    EXPECT_EQ(withData("M1"), "bad.svg:1: malformed path data: M needs two numbers (got 'M1')");
    EXPECT_EQ(withData("M&lt;"), "bad.svg:1: malformed path data: M needs two numbers (got 'M<')");
}

TEST(BadPathData, CoordinatesStayFarFromOverflow) {
    const std::string expected = "bad.svg:1: path data reaches a coordinate larger than 1e+100 (got ";
    EXPECT_EQ(withData("M0 0 L1e101 0"), expected + "'1e+101')");
    EXPECT_EQ(withData("M-1e308 0 L0 0"), expected + "'-1e+308')");
    EXPECT_EQ(withData("M1e100 0 l1e100 0"), expected + "'2e+100')");
    EXPECT_EQ(withData("M0 0 A1e200 1 0 0 0 5 5"), expected + "'1e+200')");
    EXPECT_EQ(withData("M0 0 L" + std::string(400, '9') + " 0").substr(0, 8), "bad.svg:");
    EXPECT_EQ(messageOf("<svg><g transform='scale(16)'><path d='M0 0L1e100 1'/></g></svg>"), expected + "'1.6e+101')");
}

TEST(BadTransform, IsRefusedWithItsLine) {
    const std::string malformed = "bad.svg:2: malformed transform from here on (got ";
    EXPECT_EQ(withTransform("scale(2) turn(5)"), malformed + "'turn(5)')");
    EXPECT_EQ(withTransform("matrix(1 2 3)"), malformed + "'matrix(1 2 3)')");
    EXPECT_EQ(withTransform("scale(nan)"), malformed + "'scale(nan)')");
    EXPECT_EQ(withTransform("scale(1e400)"), malformed + "'scale(1e400)')");
    EXPECT_EQ(withTransform("rotate(45deg)"), malformed + "'rotate(45deg)')");
    EXPECT_EQ(withTransform("scale(2"), malformed + "'scale(2')");
    const std::string singular = "bad.svg:2: transform is singular: it flattens every path (got ";
    EXPECT_EQ(withTransform("scale(0)"), singular + "'scale(0)')");
    EXPECT_EQ(withTransform("scale(1 0)"), singular + "'scale(1 0)')");
    EXPECT_EQ(withTransform("matrix(1 2 2 4 0 0)"), singular + "'matrix(1 2 2 4 0 0)')");
    EXPECT_EQ(withTransform("scale(1e200) scale(1e200)"),
              "bad.svg:2: transform is too large for a double (got 'scale(1e200) scale(1e200)')");
}

TEST(BadXml, IsRefusedWithItsLine) {
    EXPECT_EQ(messageOf(""), "bad.svg: has no svg element");
    EXPECT_EQ(messageOf("no markup"), "bad.svg: has no svg element");
    EXPECT_EQ(messageOf("<html>\n</html>"), "bad.svg:1: is XML, but no SVG: its root is not svg (got 'html')");
    EXPECT_EQ(messageOf("<svg xmlns='urn:other'/>"), "bad.svg:1: is XML, but no SVG: its root is not svg (got 'svg')");
    for (const char* truncated : {"<svg>\n<path d='M0 0", "<svg>\n<path d='M0 0'", "<svg>\n<g><path/>", "<svg>\n</g>",
                                  "<svg>\n<!-- ", "<svg>\n<path d=M0/></svg>", "<svg>\n<![CDATA[ "}) {
        EXPECT_EQ(messageOf(truncated).substr(0, 34), "bad.svg:2: is no well-formed XML: ") << truncated;
    }
    EXPECT_EQ(messageOf(std::string("<svg>\n\0</svg>", 13)), "bad.svg:2: is no text: it has a zero byte");
    EXPECT_EQ(messageOf(std::string("<\0s\0v\0g\0/\0>\0", 12)), "bad.svg:1: is encoded in UTF-16; save it as UTF-8");
    EXPECT_EQ(messageOf("\xFE\xFF" + std::string("\0<\0s", 4)), "bad.svg:1: is encoded in UTF-16; save it as UTF-8");
}

TEST(BadXml, EntityDeclarationsAreRefusedBeforeAnythingGrows) {
    std::string bomb = "<?xml version='1.0'?>\n<!DOCTYPE svg [\n<!ENTITY a0 'M0 0'>\n";
    for (int i = 1; i < 30; ++i) {
        const std::string before = "&a" + std::to_string(i - 1) + ";";
        bomb += "<!ENTITY a" + std::to_string(i) + " '" + before + before + before + "'>\n";
    }
    bomb += "]>\n<svg><path d='&a29;'/></svg>";
    EXPECT_EQ(messageOf(bomb), "bad.svg:3: declares entities, which are not expanded here; save it as plain SVG");
    EXPECT_EQ(messageOf("<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><svg>&x;</svg>"),
              "bad.svg:1: declares entities, which are not expanded here; save it as plain SVG");
    EXPECT_EQ(messageOf("<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'svg11.dtd'><svg><path d='M0 0'/></svg>"),
              "no error");
    EXPECT_EQ(messageOf("<svg><path d='&a29;'/></svg>").substr(0, 8), "bad.svg:") << "an entity nobody declared";
}

TEST(HarmlessXml, IsRead) {
    for (const char* text :
         {"\xEF\xBB\xBF<svg><path d='M0 0'/></svg>", "<?xml version='1.0' encoding='UTF-8'?>\r\n<svg>\r\n</svg>\r\n",
          "<svg><style><![CDATA[ path { fill: red } ]]></style><path d='M0 0'/></svg>",
          "<svg><path id='\xFF\xC0' d='M0 0L1 1'/></svg>", "<svg/>\n<!-- end -->"}) {
        EXPECT_EQ(messageOf(text), "no error") << text;
    }
}

// Recursion over the tree would need some hundred bytes of stack a level.
TEST(DeepNesting, DoesNotOverflowTheStack) {
    constexpr int depth = 300000;
    std::string text = "<svg>";
    for (int i = 0; i < depth; ++i) text += "<g>";
    text += "<path d='M0 0L1 1'/>";
    for (int i = 0; i < depth; ++i) text += "</g>";
    text += "<path d='M0 0'/></svg>";
    const auto document = parseSvg(text, "deep.svg");
    ASSERT_EQ(document.paths.size(), 2U);
    EXPECT_EQ(svgSplines(document.paths[0]).size(), 1U);
}

// With a namespace declared and a prefix looked up at each level: linear, or this would take hours.
TEST(DeepNesting, OfNamespacesTakesLinearTime) {
    constexpr int depth = 100000;
    std::string text = "<svg xmlns:s='http://www.w3.org/2000/svg'>";
    for (int i = 0; i < depth; ++i) text += "<s:g xmlns:n" + std::to_string(i) + "='u'>";
    text += "<s:path d='M0 0L1 1'/>";
    for (int i = 0; i < depth; ++i) text += "</s:g>";
    EXPECT_EQ(parseSvg(text + "</svg>", "deep.svg").paths.size(), 1U);
}

TEST(LongPaths, OfAMillionSegmentsAreRead) {
    constexpr std::size_t count = 1000000;
    std::string data = "M0 0";
    for (std::size_t i = 0; i < count; ++i) data += i % 2 == 0 ? "h1" : "v1";
    const auto document = parseSvg("<svg><path d='" + data + "'/></svg>", "long.svg");
    const auto splines = svgSplines(document.paths.at(0));
    ASSERT_EQ(splines.size(), 1U);
    EXPECT_EQ(splines.front().segments().size(), count);
}

TEST(LongPaths, BeyondTheLimitAreRefused) {
    std::string data = "M0 0h";
    for (std::size_t i = 0; i <= mostSegments; ++i) data += "1 ";
    EXPECT_EQ(withData(data), "bad.svg:1: path has more than a million segments");
}

TEST(MuchMarkup, IsRefusedBeforeItTakesMemory) {
    std::string text = "<svg>";
    for (int i = 0; i < 1000000; ++i) text += "<g/>";
    EXPECT_EQ(messageOf(text + "</svg>"), "bad.svg: has more markup than a drawing needs (got '1000002 tags')");
}

// What the reader may do with a file of chance: read it or refuse it, with its name.
void expectReadOrRefused(const std::string& text) {
    const std::string message = messageOf(text);
    EXPECT_TRUE(message == "no error" || message.starts_with("bad.svg")) << message << "\n" << text;
}

const std::string everything =
    "<?xml version='1.0'?><!DOCTYPE svg><s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><!-- a -->"
    "<s:g transform='rotate(30 1 2)scale(.5-2)' style='fill:none;x:y'><s:path id='&lt;&#65;' d='M1 2h3v4H5V6l7 8 9 "
    "1L2 3c4 5 6 7 8 9s1 2 3 4q5 6 7 8t9 1a2 3 45 0110 11A1 1 0 1 0 1e-2.5z m1,1 2,2Z'/></s:g><![CDATA[x]]></s:svg>";

TEST(FilesOfChance, CutAnywhereAreReadOrRefused) {
    ASSERT_EQ(messageOf(everything), "no error");
    for (std::size_t length = 0; length < everything.size(); ++length) {
        expectReadOrRefused(everything.substr(0, length));
    }
}

TEST(FilesOfChance, WithBytesChangedAreReadOrRefused) {
    const std::string alphabet = "MmZzLlHhVvCcSsQqTtAaEe0123456789.,-+ \t\n<>&;#'\"/=!?[]()\xFF\x80";
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(20260104, {i});
        std::string text = everything;
        for (std::uint64_t change = 0; change <= i % 4; ++change) {
            const std::size_t place = random.below(text.size());
            switch (random.below(3)) {
                case 0:
                    text[place] = alphabet[random.below(alphabet.size())];
                    break;
                case 1:
                    text.erase(place, 1 + random.below(8));
                    break;
                default:
                    text.insert(place, text.substr(random.below(text.size()), random.below(16)));
            }
        }
        expectReadOrRefused(text);
    }
}

// Every path that GNOME's designers drew for the icons of Debian's package adwaita-icon-theme.
TEST(RealFiles, EveryPathOfTheAdwaitaIconsIsReadOrRefusedWithTheReason) {
    const fs::path icons = "/usr/share/icons/Adwaita";
    ASSERT_TRUE(fs::is_directory(icons)) << "install Debian's package adwaita-icon-theme, which this test reads";
    int files = 0;
    int paths = 0;
    std::vector<std::string> refused;
    for (const auto& entry : fs::recursive_directory_iterator(icons)) {
        if (entry.path().extension() != ".svg") continue;
        ++files;
        try {
            const SvgDocument document = parseSvg(readTextFile(entry.path(), mostProfileBytes), entry.path().string());
            for (const SvgPathElement& path : document.paths) {
                ++paths;
                try {
                    EXPECT_FALSE(svgSplines(path).empty()) << entry.path() << ":" << path.line << " draws nothing";
                } catch (const InputError& error) {
                    refused.emplace_back(error.what());
                }
            }
        } catch (const InputError& error) {
            refused.emplace_back(error.what());
        }
    }
    std::cout << files << " files, " << paths << " paths, " << refused.size() << " refused\n";
    for (const std::string& reason : refused) {
        std::cout << "refused: " << reason << "\n";
        EXPECT_EQ(reason.find(icons.string()), 0U) << "a refusal names its file";
    }
    EXPECT_GT(files, 500);
    EXPECT_GT(paths, files) << "are there files whose paths are not found?";
    EXPECT_LE(refused.size(), static_cast<std::size_t>(paths) / 100) << "almost none may be refused";
}

}  // namespace
}  // namespace caustic
