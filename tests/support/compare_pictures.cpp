// compare_pictures YOURS REFERENCE OUT [AGAIN]: draws two pictures and their difference side by side, and prints
// - the share of pixels that differ (in percent) and the largest difference of a channel (of 255),
// - the root mean square of the differences of blocks' means, and the same between YOURS and AGAIN, which was drawn
// with
//   another seed: 0 without it,
// - the largest difference of a block's mean, and where that block lies (x y).
// ./course check runs it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace {

constexpr int captionHeight = 36;
constexpr int gap = 8;
constexpr int blockSize = 16;
constexpr int barelyVisible = 2;  // of 255: less is rounding
constexpr double gain = 4;        // so that small differences can be seen

cv::Mat read(const std::string& path) {
    cv::Mat picture = cv::imread(path, cv::IMREAD_COLOR);
    if (picture.empty()) throw std::runtime_error(path + " cannot be read as a picture");
    return picture;
}

cv::Mat largestOfChannels(const cv::Mat& picture) {
    std::vector<cv::Mat> channels;
    cv::split(picture, channels);
    cv::Mat largest = channels.front();
    for (const cv::Mat& channel : channels) largest = cv::max(largest, channel);
    return largest;
}

cv::Mat captioned(const cv::Mat& picture, const std::string& caption) {
    cv::Mat framed;
    cv::copyMakeBorder(picture, framed, captionHeight, gap, gap, gap, cv::BORDER_CONSTANT, cv::Scalar::all(255));
    cv::putText(framed, caption, {gap, captionHeight - 12}, cv::FONT_HERSHEY_SIMPLEX, 0.7, cv::Scalar::all(0), 1,
                cv::LINE_AA);
    return framed;
}

struct Blocks {
    double rootMeanSquare = 0;  ///< of the differences of means of a channel, of 255
    double largest = 0;
    cv::Point corner;  ///< of the block with the largest
};

// Noise shrinks in a block's mean, and what is wrong does not.
Blocks compareBlocks(const cv::Mat& yours, const cv::Mat& other) {
    Blocks found;
    double squares = 0;
    int count = 0;
    for (int y = 0; y < yours.rows; y += blockSize) {
        for (int x = 0; x < yours.cols; x += blockSize) {
            const cv::Rect block(x, y, std::min(blockSize, yours.cols - x), std::min(blockSize, yours.rows - y));
            const cv::Scalar difference = cv::mean(yours(block)) - cv::mean(other(block));
            for (int channel = 0; channel < 3; ++channel) {
                const double size = std::abs(difference[channel]);
                squares += size * size;
                ++count;
                if (size > found.largest) {
                    found.largest = size;
                    found.corner = block.tl();
                }
            }
        }
    }
    found.rootMeanSquare = std::sqrt(squares / count);
    return found;
}

void compare(const std::string& yoursPath, const std::string& referencePath, const std::string& outPath,
             const std::string& againPath) {
    const cv::Mat yours = read(yoursPath);
    cv::Mat reference = read(referencePath);
    if (reference.size() != yours.size()) cv::resize(reference, reference, yours.size(), 0, 0, cv::INTER_AREA);

    cv::Mat difference;
    cv::absdiff(yours, reference, difference);
    const cv::Mat largest = largestOfChannels(difference);
    double worst = 0;
    cv::minMaxLoc(largest, nullptr, &worst);
    const int differing = cv::countNonZero(largest > barelyVisible);
    // Dark where the pictures differ, on white as they are themselves.
    const cv::Mat shown = cv::Scalar::all(255) - gain * difference;

    cv::Mat sideBySide;
    cv::hconcat(std::vector<cv::Mat>{captioned(yours, "yours"), captioned(reference, "reference"),
                                     captioned(shown, "difference x 4, dark where they differ")},
                sideBySide);
    if (!cv::imwrite(outPath, sideBySide)) throw std::runtime_error(outPath + " cannot be written");
    const Blocks blocks = compareBlocks(yours, reference);
    const Blocks noise = againPath.empty() ? Blocks{} : compareBlocks(yours, read(againPath));
    std::printf("%.4f %.0f %.3f %.3f %.1f %d %d\n", 100.0 * differing / static_cast<double>(largest.total()), worst,
                blocks.rootMeanSquare, noise.rootMeanSquare, blocks.largest, blocks.corner.x, blocks.corner.y);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 5) {
        std::fprintf(stderr, "usage: compare_pictures YOURS REFERENCE OUT [AGAIN]\n");
        return 2;
    }
    try {
        compare(argv[1], argv[2], argv[3], argc == 5 ? argv[4] : "");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_pictures: %s\n", error.what());
        return 1;
    }
}
