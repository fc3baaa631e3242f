// preview FILE: shows a picture in a window until a key is pressed or the window is closed.
//
// The chapters' --preview runs it: a program of its own, so that no chapter has to load a window system.

#include <cstdio>
#include <opencv2/highgui.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

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
    while (cv::waitKey(pauseMs) == noKey && cv::getWindowProperty(file, cv::WND_PROP_VISIBLE) >= 1) continue;
    return 0;
}
