#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/check.h"
#include "core/random.h"
#include "core/text.h"
#include "figure/csv_table.h"

namespace caustic {
namespace {

double fromBits(std::uint64_t bits) {
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// Every bit pattern that is a finite number must survive the way through a CSV file.
TEST(Text, NumbersReadBackExactly) {
    Random random(1, {1});
    for (int trial = 0; trial < 20000; ++trial) {
        const double value = fromBits(random.below(std::numeric_limits<std::uint64_t>::max()));
        if (!std::isfinite(value)) continue;
        EXPECT_EQ(parseReal(formatReal(value)), value) << formatReal(value);
    }
    EXPECT_TRUE(std::signbit(parseReal(formatReal(-0.0)).value()));
}

TEST(Text, NumbersAreWrittenShort) {
    EXPECT_EQ(formatReal(0.1), "0.1");
    EXPECT_EQ(formatReal(-2), "-2");
    EXPECT_EQ(formatReal(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(formatReal(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Text, ParseTakesTheWholeTextOrNothing) {
    EXPECT_EQ(parseReal("+1.5e-3"), 0.0015);
    EXPECT_EQ(parseReal(".5"), 0.5);
    EXPECT_TRUE(std::isnan(parseReal("nan").value()));
    for (const char* text : {"", "+", "1 ", " 1", "1,5", "1.5x", "0x10", "1e400", "-1e999", "--1", "one"}) {
        EXPECT_FALSE(parseReal(text).has_value()) << "'" << text << "'";
    }
    EXPECT_EQ(parseInteger("-42"), -42);
    EXPECT_EQ(parseInteger("+7"), 7);
    for (const char* text : {"", "7.0", "7 ", "9223372036854775808", "x"}) {
        EXPECT_FALSE(parseInteger(text).has_value()) << "'" << text << "'";
    }
}

TEST(Text, TrimmedTakesSpaceFromBothEnds) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \n "), "");
    EXPECT_EQ(trimmed(""), "");
}

class TextFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) / ("text_file." + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path fileWith(const std::string& text) const {
        std::ofstream(folder_ / "file.txt", std::ios::binary) << text;
        return folder_ / "file.txt";
    }

    std::filesystem::path folder_;
};

TEST_F(TextFile, IsReadByteForByte) {
    const std::string text("a\r\nb\0c\n", 7);
    EXPECT_EQ(readTextFile(fileWith(text), 100), text);
    EXPECT_EQ(readTextFile(fileWith(""), 100), "");
}

TEST_F(TextFile, OfTheLargestAllowedSizeIsReadAndOneByteMoreIsNot) {
    const auto path = fileWith(std::string(200000, 'x'));
    EXPECT_EQ(readTextFile(path, 200000).size(), 200000U);
    EXPECT_THROW(readTextFile(path, 199999), InputError);
}

// /dev/zero has no size to ask for and never ends: only counting while reading stops it.
TEST_F(TextFile, WithoutAnEndIsRefused) { EXPECT_THROW(readTextFile("/dev/zero", 1 << 20), InputError); }

TEST_F(TextFile, MissingOrAFolderIsRefusedByName) {
    for (const auto& path : {folder_ / "missing.txt", folder_}) {
        try {
            readTextFile(path, 100);
            FAIL() << path << " was read";
        } catch (const InputError& error) {
            EXPECT_EQ(error.place().file, path.string());
            EXPECT_FALSE(error.reason().empty());
        }
    }
}

TEST(InputErrorText, NamesFileLineReasonAndValue) {
    const InputError error({"curve.txt", 3}, "abc", "must be a number");
    EXPECT_STREQ(error.what(), "curve.txt:3: must be a number (got 'abc')");
    EXPECT_STREQ(InputError({"--seed", 0}, "", "is missing").what(), "--seed: is missing");
}

// A hostile file must not fill the terminal or steer it: long values are cut, control characters blanked.
TEST(InputErrorText, IsOneShortLine) {
    const InputError error({"f", 0}, "\x1b[2J\n" + std::string(5000, 'x'), "is wrong");
    const std::string text = error.what();
    EXPECT_LT(text.size(), 120U);
    for (const char c : text) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
}

TEST(Check, RefusesWhatIsNotFiniteOrNotPositive) {
    EXPECT_NO_THROW(checkFinite(-1e308, "x"));
    EXPECT_NO_THROW(checkPositive(1e-308, "x"));
    EXPECT_THROW(checkFinite(std::numeric_limits<double>::quiet_NaN(), "x"), InputError);
    EXPECT_THROW(checkFinite(std::numeric_limits<double>::infinity(), "x"), InputError);
    for (const double value : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW(checkPositive(value, "x"), InputError) << value;
    }
}

// RFC 4180: quotes only where a comma, quote or line break asks for them; an inner quote is doubled.
TEST(Csv, QuotesOnlyWhereNeeded) {
    CsvTable table({"method", "value"});
    table.addRow("plain", 0.1);
    table.addRow("a,b", 3);
    table.addRow("say \"x\"", std::size_t{7});
    EXPECT_EQ(table.text(), "method,value\nplain,0.1\n\"a,b\",3\n\"say \"\"x\"\"\",7\n");
    EXPECT_EQ(table.rows().size(), 3U);
    EXPECT_EQ(table.columns().front(), "method");
}

TEST(Csv, RowOfTheWrongLengthIsRefused) {
    CsvTable table({"a", "b"});
    EXPECT_THROW(table.addRow(1), InputError);
    EXPECT_THROW(table.addRow(1, 2, 3), InputError);
    EXPECT_TRUE(table.rows().empty());
}

}  // namespace
}  // namespace caustic
