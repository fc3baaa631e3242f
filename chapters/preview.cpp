// preview FILE: shows a picture in a window until a key is pressed or the window is closed. When the file changes, so
// does what is shown: a picture can be watched while it grows.
//
// The chapters' --preview runs it: a program of its own, so that no chapter has to load a window system.

#include <cstdio>
#include <filesystem>
#include <opencv2/highgui.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <system_error>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: preview FILE\n");
        return 2;
    }
    const std::string file = argv[1];
    const cv::Mat picture = cv::imread(file, cv::IMREAD_COLOR);
    if (picture.empty()) {
        std::fprintf(stderr, "preview: %s is no picture that can be read\n", file.c_str());
        return 2;
    }
    constexpr int pauseMs = 50;
    constexpr int noKey = -1;
    cv::namedWindow(file, cv::WINDOW_AUTOSIZE);
    cv::imshow(file, picture);
    std::error_code missing;
    auto written = std::filesystem::last_write_time(file, missing);
    while (cv::waitKey(pauseMs) == noKey && cv::getWindowProperty(file, cv::WND_PROP_VISIBLE) >= 1) {
        const auto now = std::filesystem::last_write_time(file, missing);
        if (missing || now == written) continue;
        written = now;
        const cv::Mat next = cv::imread(file, cv::IMREAD_COLOR);
        if (!next.empty()) cv::imshow(file, next);
    }
    return 0;
}
