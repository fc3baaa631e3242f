#include "image/image_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "image/color_space.h"
#include "image/image_header.h"
#include "image/opencv_io.h"

namespace caustic {

namespace {

// Largest value that Radiance's exponent byte can hold.
constexpr float largestRadiance = 1.6e38F;

// The value of each code.
std::vector<float> decodingTable(int codes, Encoding encoding) {
    std::vector<float> table(static_cast<std::size_t>(codes));
    for (int code = 0; code < codes; ++code) {
        const Real value = Real(code) / (codes - 1);
        table[static_cast<std::size_t>(code)] =
            static_cast<float>(encoding == Encoding::Srgb ? srgbDecode(value) : value);
    }
    return table;
}

// Copies the pixels of `mat` (blue first) into an image (red first).
template <typename Value, typename Decode>
Image toImage(const cv::Mat& mat, const Decode& decode) {
    Image image(mat.cols, mat.rows);
    float* to = image.data().data();
    for (int y = 0; y < mat.rows; ++y) {
        const Value* from = mat.ptr<Value>(y);
        for (int x = 0; x < mat.cols; ++x, from += 3, to += 3) {
            for (int channel = 0; channel < 3; ++channel) to[channel] = decode(from[2 - channel]);
        }
    }
    return image;
}

template <typename Value, typename Encode>
cv::Mat toMat(const Image& image, int type, const Encode& encode) {
    cv::Mat mat(image.height(), image.width(), type);
    const float* from = image.data().data();
    for (int y = 0; y < mat.rows; ++y) {
        Value* to = mat.ptr<Value>(y);
        for (int x = 0; x < mat.cols; ++x, from += 3, to += 3) {
            for (int channel = 0; channel < 3; ++channel) to[channel] = encode(from[2 - channel]);
        }
    }
    return mat;
}

void checkValues(const Image& image, const std::string& file) {
    const auto values = image.data();
    const auto wrong = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
    if (wrong == values.end()) return;
    const std::ptrdiff_t pixel = (wrong - values.begin()) / 3;
    throw InputError({file, 0}, std::to_string(*wrong),
                     "the pixel in column " + std::to_string(pixel % image.width()) + ", row " +
                         std::to_string(pixel / image.width()) + " is not finite");
}

template <typename Code>
cv::Mat toPng(const Image& image, int type) {
    constexpr Real largest = std::numeric_limits<Code>::max();
    return toMat<Code>(image, type,
                       [](float value) { return static_cast<Code>(std::lround(srgbEncode(Real(value)) * largest)); });
}

}  // namespace

Image loadImage(const std::filesystem::path& path, Encoding encoding) {
    const ImageHeader header = readImageHeader(path);
    checkImageSize(header.width, header.height, path.string());
    const cv::Mat mat = readMat(path);
    if (mat.type() == CV_8UC3) {
        const auto table = decodingTable(256, encoding);
        return toImage<std::uint8_t>(mat, [&](std::uint8_t code) { return table[code]; });
    }
    if (mat.type() == CV_16UC3) {
        const auto table = decodingTable(65536, encoding);
        return toImage<std::uint16_t>(mat, [&](std::uint16_t code) { return table[code]; });
    }
    if (mat.type() != CV_32FC3)
        throw InputError({path.string(), 0}, "", "has pixels that are neither codes nor floats");
    Image image = toImage<float>(mat, [](float value) { return value; });
    checkValues(image, path.string());
    return image;
}

void saveImage(const std::filesystem::path& path, const Image& image, PngDepth depth) {
    checkValues(image, path.string());
    const std::string extension = path.extension().string();
    if (extension == ".png" && depth == PngDepth::Bits8) return writeMat(path, toPng<std::uint8_t>(image, CV_8UC3));
    if (extension == ".png") return writeMat(path, toPng<std::uint16_t>(image, CV_16UC3));
    if (extension == ".exr") return writeMat(path, toMat<float>(image, CV_32FC3, [](float value) { return value; }));
    if (extension == ".hdr") {
        const auto clamped = [](float value) { return std::clamp(value, 0.0F, largestRadiance); };
        return writeMat(path, toMat<float>(image, CV_32FC3, clamped));
    }
    throw InputError({path.string(), 0}, extension, "images are saved as .png, .exr or .hdr");
}

}  // namespace caustic
