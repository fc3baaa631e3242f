#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/random.h"
#include "image/color_space.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

// Every 8-bit code in every channel, in linear light.
Image everyCode() {
    Image image(16, 16);
    for (int code = 0; code < 256; ++code) {
        const Color codes(code, 255 - code, (code * 7) % 256);
        image.set(code % 16, code / 16, srgbDecode(Color(codes / 255)));
    }
    return image;
}

// High dynamic range: 1e-3 to 1e4, chosen by the exponent.
Image wideRange(int width, int height) {
    Random random(21, {0});
    Image image(width, height);
    for (float& value : image.data()) value = static_cast<float>(std::pow(10, random.uniform(-3, 4)));
    return image;
}

Real largestDifference(const Image& a, const Image& b) {
    Real largest = 0;
    for (std::size_t i = 0; i < a.data().size(); ++i) {
        largest = std::max(largest, std::abs(Real(a.data()[i]) - Real(b.data()[i])));
    }
    return largest;
}

TEST(ImageFile, PngBringsEveryCodeBack) {
    const test::TemporaryFolder folder;
    const Image image = everyCode();
    saveImage(folder / "a.png", image);
    const Image back = loadImage(folder / "a.png");
    ASSERT_EQ(back.width(), 16);
    ASSERT_EQ(back.height(), 16);
    EXPECT_LT(largestDifference(image, back), 1e-7);
}

// The file's own codes, read by OpenCV (blue first): 0.5 is stored as 188 (IEC 61966-2-1), 0.0031308 as 10.
TEST(ImageFile, PngIsSrgbEncodedAndClamped) {
    const test::TemporaryFolder folder;
    Image image(2, 1);
    image.set(0, 0, Color(0.5, 0.0031308, 1));
    image.set(1, 0, Color(-4, 1e6, 0));
    saveImage(folder / "a.png", image);
    const cv::Mat mat = cv::imread((folder / "a.png").string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(mat.type(), CV_8UC3);
    EXPECT_EQ(mat.at<cv::Vec3b>(0, 0), cv::Vec3b(255, 10, 188)) << "Are red and blue in their places?";
    EXPECT_EQ(mat.at<cv::Vec3b>(0, 1), cv::Vec3b(0, 255, 0));
}

TEST(ImageFile, SixteenBitPngIsAsFineAsItsCodes) {
    const test::TemporaryFolder folder;
    Random random(22, {0});
    Image image(64, 64);
    for (float& value : image.data()) value = static_cast<float>(random.uniform());
    saveImage(folder / "a.png", image, PngDepth::Bits16);
    ASSERT_EQ(cv::imread((folder / "a.png").string(), cv::IMREAD_UNCHANGED).type(), CV_16UC3);
    // Half a code, times the decoding's steepest slope, 2.4 / 1.055 at white.
    EXPECT_LT(largestDifference(image, loadImage(folder / "a.png")), 0.5 / 65535 * 2.4 / 1.055 + 1e-7);
}

// A normal map's codes are data: (128, 128, 255) must come back as these very codes.
TEST(ImageFile, LinearEncodingGivesTheCodes) {
    const test::TemporaryFolder folder;
    cv::Mat mat(1, 256, CV_8UC3);
    for (int code = 0; code < 256; ++code) {
        mat.at<cv::Vec3b>(0, code) = {255, 128, static_cast<std::uint8_t>(code)};
    }
    cv::imwrite((folder / "a.png").string(), mat);
    const Image image = loadImage(folder / "a.png", Encoding::Linear);
    for (int code = 0; code < 256; ++code) {
        const Color codes = 255 * image.at(code, 0);
        EXPECT_EQ(std::lround(codes.x()), code);
        EXPECT_EQ(std::lround(codes.y()), 128) << "Was data decoded as if it were a colour?";
    }
}

TEST(ImageFile, OpenExrKeepsEveryBit) {
    const test::TemporaryFolder folder;
    Image image = wideRange(33, 17);
    image.set(0, 0, Color(-1.5, 0, 1e30));
    saveImage(folder / "a.exr", image);
    EXPECT_EQ(largestDifference(image, loadImage(folder / "a.exr")), 0);
    EXPECT_EQ(largestDifference(image, loadImage(folder / "a.exr", Encoding::Srgb)), 0) << "Floats are linear.";
}

// RGBE (Ward 1991): 8 bits of mantissa under the largest channel's exponent; truncation errs by at most one step.
TEST(ImageFile, RadianceKeepsEightBitsOfTheLargestChannel) {
    const test::TemporaryFolder folder;
    const Image image = wideRange(33, 17);
    saveImage(folder / "a.hdr", image);
    const Image back = loadImage(folder / "a.hdr");
    for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 33; ++x) {
            EXPECT_LE((image.at(x, y) - back.at(x, y)).abs().maxCoeff(), image.at(x, y).maxCoeff() / 128);
        }
    }
}

TEST(ImageFile, RadianceHasNoSign) {
    const test::TemporaryFolder folder;
    saveImage(folder / "a.hdr", Image(3, 3, Color(-1, 0.5, -1e-8)));
    const Color back = loadImage(folder / "a.hdr").at(1, 1);
    EXPECT_EQ(back.x(), 0);
    EXPECT_NEAR(back.y(), 0.5, 0.5 / 128);
    EXPECT_EQ(back.z(), 0);
}

// JPEG is lossy, so a smooth picture at high quality: a few codes of 255.
TEST(ImageFile, JpegIsReadInSrgb) {
    const test::TemporaryFolder folder;
    cv::Mat mat(64, 64, CV_8UC3);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            mat.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(3 * x), 100, static_cast<std::uint8_t>(3 * y)};
        }
    }
    cv::imwrite((folder / "a.jpg").string(), mat, {cv::IMWRITE_JPEG_QUALITY, 98});
    const Image image = loadImage(folder / "a.jpg");
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const Color codes = 255 * srgbEncode(image.at(x, y));
            EXPECT_LT((codes - Color(3 * y, 100, 3 * x)).abs().maxCoeff(), 6);
        }
    }
}

TEST(ImageFile, GreyGetsThreeChannelsAndAlphaIsDropped) {
    const test::TemporaryFolder folder;
    cv::imwrite((folder / "grey.png").string(), cv::Mat(2, 2, CV_8UC1, cv::Scalar(188)));
    EXPECT_TRUE(loadImage(folder / "grey.png").at(1, 1).isApproxToConstant(srgbDecode(188 / Real(255)), 1e-6));
    cv::imwrite((folder / "alpha.png").string(), cv::Mat(2, 2, CV_8UC4, cv::Scalar(10, 20, 30, 0)));
    const Color codes = 255 * srgbEncode(loadImage(folder / "alpha.png").at(0, 1));
    EXPECT_LT((codes - Color(30, 20, 10)).abs().maxCoeff(), 1e-3);
}

TEST(ImageFile, ContentTellsTheFormatNotTheName) {
    const test::TemporaryFolder folder;
    saveImage(folder / "a.exr", Image(2, 2, Color(7, 7, 7)));
    std::filesystem::rename(folder / "a.exr", folder / "a.png");
    EXPECT_EQ(loadImage(folder / "a.png").at(0, 0).x(), 7);
}

TEST(ImageFile, SavingMakesTheFolderAndLeavesNoOtherFile) {
    const test::TemporaryFolder folder;
    for (const char* name : {"x/a.png", "x/a.exr", "x/a.hdr"}) saveImage(folder / name, Image(2, 2));
    const auto entries = std::filesystem::directory_iterator(folder / "x");
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 3) << "Did a temporary file stay?";
}

}  // namespace
}  // namespace caustic
