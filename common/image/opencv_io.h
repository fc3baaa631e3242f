#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace caustic {

/// OpenCV's image files, with failures as InputError and without the messages that OpenCV and the libraries below it
/// print. For the sources of this folder: nobody else sees OpenCV's types.

/// Decodes an image file to three channels (blue, green, red) of 8 or 16 bits or float; alpha is dropped.
/// @throws InputError when it is damaged; what the decoder complained of is the reason
cv::Mat readMat(const std::filesystem::path& path);

/// Writes an image in the format that the extension names, through a temporary file and a rename.
/// @throws InputError when it cannot be written
void writeMat(const std::filesystem::path& path, const cv::Mat& mat);

}  // namespace caustic
