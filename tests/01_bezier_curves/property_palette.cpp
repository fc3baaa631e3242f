#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "image/drawing.h"
#include "support/paths.h"

namespace caustic {
namespace {

// Figures that are drawn and charts that are plotted share their colours: style.gp's line types, in order.
TEST(Palette, IsThatOfTheCharts) {
    const Ink inks[] = {palette::blue,   palette::vermilion, palette::green, palette::purple,
                        palette::orange, palette::sky,       palette::dark,  palette::brown};
    std::ifstream style(test::sourceDir() / "common/figure/style.gp");
    const std::regex lineType(R"re(set linetype (\d) lc rgb "#(..)(..)(..)".*)re");
    std::size_t found = 0;
    for (std::string line; std::getline(style, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, lineType)) continue;
        const auto channel = [&](std::size_t i) { return static_cast<std::uint8_t>(std::stoi(match[i], nullptr, 16)); };
        ASSERT_LT(found, std::size(inks));
        EXPECT_EQ(inks[found], (Ink{channel(2), channel(3), channel(4)})) << line;
        ++found;
    }
    EXPECT_EQ(found, std::size(inks));
}

}  // namespace
}  // namespace caustic
