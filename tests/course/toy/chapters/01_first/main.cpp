#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "math/sums.h"

namespace {

void drawBars(caustic::FigureContext& context) {
    cv::Mat picture(100, 160, CV_8UC3, cv::Scalar::all(255));
    const int height = static_cast<int>(caustic::total({10, 20, 30}));
    cv::rectangle(picture, {20, 100 - height}, {60, 99}, {200, 90, 40}, cv::FILLED);
    std::filesystem::create_directories(context.output("bars.png").parent_path());
    cv::imwrite(context.output("bars.png").string(), picture);
}

void drawMean(caustic::FigureContext& context) {
    cv::Mat picture(50, 50, CV_8UC3, cv::Scalar::all(caustic::mean({100, 200})));
    cv::imwrite(context.output("mean.png").string(), picture);
}

}  // namespace

int main(int argc, char** argv) {
    return caustic::runChapter(thisChapter, argc, argv, {{"bars", drawBars}, {"mean", drawMean}});
}
