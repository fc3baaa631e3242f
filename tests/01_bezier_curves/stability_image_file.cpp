#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "core/error.h"
#include "core/random.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// The reason why a file isn't loaded; empty when it is. Whatever the decoders print fails the test.
std::string refusal(const std::filesystem::path& path) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string reason;
    try {
        loadImage(path);
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, path.string()) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "One line for the user?";
        reason = error.reason();
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "Does a decoder talk to the user?";
    return reason;
}

std::string bigEndian(std::uint32_t value) {
    std::string text;
    for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(value >> shift & 0xff);
    return text;
}

Image noise(int width, int height) {
    Random random(31, {0});
    Image image(width, height);
    for (float& value : image.data()) value = static_cast<float>(random.uniform());
    return image;
}

// One valid file of each kind that can be read.
std::vector<std::filesystem::path> oneOfEach(const test::TemporaryFolder& folder) {
    saveImage(folder / "a.png", noise(13, 9));
    saveImage(folder / "b.png", noise(13, 9), PngDepth::Bits16);
    saveImage(folder / "c.exr", noise(13, 9));
    saveImage(folder / "d.hdr", noise(13, 9));
    cv::imwrite((folder / "e.jpg").string(), cv::imread((folder / "a.png").string()));
    return {folder / "a.png", folder / "b.png", folder / "c.exr", folder / "d.hdr", folder / "e.jpg"};
}

TEST(ImageFileStability, WhatIsNoFileIsRefused) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(refusal(folder / "none.png"), "no such file");
    EXPECT_EQ(refusal(folder.path()), "is a folder, not a file");
    write(folder / "empty.png", "");
    EXPECT_EQ(refusal(folder / "empty.png"), "is empty");
    // As root even a file of mode 000 can be read; the memory of a process cannot, at its address 0, by anybody.
    EXPECT_EQ(refusal("/proc/self/mem"), "cannot be read");
}

TEST(ImageFileStability, OtherFormatsAreRefusedByName) {
    const test::TemporaryFolder folder;
    write(folder / "text.png", "This is no picture at all, whatever its name says.");
    write(folder / "vector.png", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    cv::imwrite((folder / "a.tiff").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
    cv::imwrite((folder / "a.bmp").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
    for (const char* name : {"text.png", "vector.png", "a.tiff", "a.bmp"}) {
        EXPECT_NE(refusal(folder / name).find("PNG, JPEG, OpenEXR or Radiance"), std::string::npos) << name;
    }
}

// Cut at every length, none of the formats may come back as a picture with a grey rest.
TEST(ImageFileStability, TruncatedFilesAreRefusedAtEveryLength) {
    const test::TemporaryFolder folder;
    for (const auto& path : oneOfEach(folder)) {
        const std::string whole = contents(path);
        ASSERT_EQ(refusal(path), "");
        const std::size_t step = whole.size() / 150 + 1;
        for (std::size_t length = 0; length < whole.size(); length += step) {
            write(path, whole.substr(0, length));
            ASSERT_NE(refusal(path), "") << path.filename() << " cut to " << length << " of " << whole.size();
        }
    }
}

// Damaged bytes must end in a picture or in an InputError, and never in a crash or a message past the user's error.
TEST(ImageFileStability, DamagedBytesNeverCrash) {
    const test::TemporaryFolder folder;
    Random random(32, {0});
    for (const auto& path : oneOfEach(folder)) {
        const std::string whole = contents(path);
        for (int trial = 0; trial < 200; ++trial) {
            std::string damaged = whole;
            for (int i = 0; i < 4; ++i) damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
            write(path, damaged);
            refusal(path);
        }
    }
}

// The header alone decides: no memory is asked for a picture that cannot be held.
TEST(ImageFileStability, AbsurdSizesAreRefusedBeforeDecoding) {
    const test::TemporaryFolder folder;
    const std::string signature = "\x89PNG\r\n\x1a\n";
    const std::string chunk = std::string("\0\0\0\x0d", 4) + "IHDR";
    write(folder / "a.png", signature + chunk + bigEndian(1U << 30) + bigEndian(1U << 30) + "\x08\x02");
    write(folder / "b.png", signature + chunk + bigEndian(0) + bigEndian(5) + "\x08\x02");
    write(folder / "c.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999999 +X 99999999\n");
    write(folder / "d.hdr", "#?RADIANCE\n\n-Y 0 +X 4\n");
    saveImage(folder / "e.exr", Image(2, 2));
    std::string exr = contents(folder / "e.exr");
    const std::size_t window = exr.find("dataWindow") + std::string("dataWindow.box2i.").size() + 4;
    exr.replace(window + 8, 8, "\xff\xff\xff\x7f\xff\xff\xff\x7f");
    write(folder / "e.exr", exr);
    const std::string jpegFrame = std::string("\xff\xd8\xff\xc0\x00\x11\x08\xff\xff\xff\xff\x03", 12);
    write(folder / "f.jpg", jpegFrame);
    for (const char* name : {"a.png", "b.png", "c.hdr", "d.hdr", "e.exr", "f.jpg"}) {
        EXPECT_NE(refusal(folder / name).find("sides of at least 1"), std::string::npos) << name;
    }
}

TEST(ImageFileStability, HeadersThatLieAreRefused) {
    const test::TemporaryFolder folder;
    write(folder / "a.hdr", "#?RADIANCE\n\n+X 4 -Y 4\n....");
    write(folder / "b.hdr", "#?RADIANCE\n\n-Y four +X 4\n");
    write(folder / "c.hdr", "#?" + std::string(100000, 'x'));
    write(folder / "d.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dJUNK", 16) + std::string(20, 'x'));
    write(folder / "e.jpg", std::string("\xff\xd8\xff\xe0\x00\x01xxxx", 10));
    write(folder / "f.jpg", std::string("\xff\xd8\xff\xe0\x00\x04xxxx", 10));
    write(folder / "g.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0name\0type\0\xff\xff\xff\xff", 22));
    write(folder / "h.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0\0", 9));
    for (const char* name : {"a.hdr", "b.hdr", "c.hdr", "d.png", "e.jpg", "f.jpg", "g.exr", "h.exr"}) {
        EXPECT_NE(refusal(folder / name), "") << name;
    }
}

TEST(ImageFileStability, NonFinitePixelsNeverComeInOrGoOut) {
    const test::TemporaryFolder folder;
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image image(4, 3);
        image.data()[3 * (2 * 4 + 1)] = value;
        for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
            try {
                saveImage(folder / name, image);
                ADD_FAILURE() << name << " was written";
            } catch (const InputError& error) {
                EXPECT_NE(error.reason().find("column 1, row 2"), std::string::npos) << error.what();
            }
            EXPECT_FALSE(std::filesystem::exists(folder / name));
        }
        saveImage(folder / "good.exr", Image(4, 3));
        cv::Mat mat = cv::Mat::zeros(3, 4, CV_32FC3);
        mat.at<cv::Vec3f>(2, 1)[2] = value;
        cv::imwrite((folder / "bad.exr").string(), mat);
        EXPECT_NE(refusal(folder / "bad.exr").find("column 1, row 2"), std::string::npos);
    }
}

TEST(ImageFileStability, WhatCannotBeWrittenIsSaid) {
    const test::TemporaryFolder folder;
    write(folder / "file", "x");
    for (const auto& path : {folder / "file" / "a.png", std::filesystem::path("/proc/a.png")}) {
        testing::internal::CaptureStderr();
        EXPECT_THROW(saveImage(path, Image(2, 2)), InputError) << path;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }
    for (const char* name : {"a.jpg", "a.tiff", "a", "a.PNGX"}) {
        EXPECT_THROW(saveImage(folder / name, Image(2, 2)), InputError) << name;
        EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
    std::filesystem::create_directory(folder / "folder.png");
    EXPECT_THROW(saveImage(folder / "folder.png", Image(2, 2)), InputError);
}

TEST(ImageFileStability, AFailedSaveLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    saveImage(folder / "a.png", Image(2, 2, Color(1, 1, 1)));
    Image broken(2, 2);
    broken.data()[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(saveImage(folder / "a.png", broken), InputError);
    EXPECT_EQ(loadImage(folder / "a.png").at(0, 0).x(), 1);
}

}  // namespace
}  // namespace caustic
