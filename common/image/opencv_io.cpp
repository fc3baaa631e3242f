#include "image/opencv_io.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"

namespace caustic {

namespace {

// libpng, libjpeg and OpenCV print what they dislike; there is no other way to hear it through OpenCV. While an object
// lives, standard error flows into a temporary file. The descriptor belongs to the whole process, hence the lock.
class CapturedStandardError {
public:
    CapturedStandardError() : lock_(mutex()), file_(std::tmpfile()) {
        std::fflush(stderr);
        if (file_ == nullptr) return;
        saved_ = dup(STDERR_FILENO);
        dup2(fileno(file_), STDERR_FILENO);
    }
    CapturedStandardError(const CapturedStandardError&) = delete;
    CapturedStandardError& operator=(const CapturedStandardError&) = delete;
    ~CapturedStandardError() {
        if (file_ == nullptr) return;
        std::fflush(stderr);
        if (saved_ >= 0) {
            dup2(saved_, STDERR_FILENO);
            close(saved_);
        }
        std::fclose(file_);
    }

    std::string text() const {
        if (file_ == nullptr) return "";
        std::fflush(stderr);
        std::rewind(file_);
        std::array<char, 512> buffer{};
        const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_);
        return {buffer.data(), count};
    }

private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }

    std::scoped_lock<std::mutex> lock_;
    std::FILE* file_;
    int saved_ = -1;
};

// Debian's OpenCV reads and writes OpenEXR only where this says so, and looks at it once, at the first OpenEXR file.
void enableOpenExr() { setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 1); }

// libjpeg takes damaged data for an image and mentions it in passing: the rest of the picture is grey.
bool tellsOfDamage(const std::string& complaint) {
    const bool damaged = complaint.find("Corrupt JPEG data") != std::string::npos ||
                         complaint.find("Premature end of JPEG") != std::string::npos;
    return damaged && complaint.find("extraneous bytes") == std::string::npos;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

cv::Mat readMat(const std::filesystem::path& path) {
    cv::Mat mat;
    std::string complaint;
    {
        const CapturedStandardError captured;
        enableOpenExr();
        try {
            mat = cv::imread(path.string(), cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
            complaint = captured.text();
        } catch (const std::exception& error) {
            complaint = error.what();
        }
    }
    if (mat.empty() || tellsOfDamage(complaint))
        throw InputError({path.string(), 0}, firstLine(complaint), "cannot be decoded; is it truncated or damaged?");
    return mat;
}

void writeMat(const std::filesystem::path& path, const cv::Mat& mat) {
    // Figures are committed, so PNGs are packed as small as they go; the writer of Radiance takes no such parameter.
    std::vector<int> parameters;
    if (path.extension() == ".png") parameters = {cv::IMWRITE_PNG_COMPRESSION, 9};
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        bool written = false;
        {
            const CapturedStandardError captured;
            enableOpenExr();
            try {
                written = cv::imwrite(temporary.string(), mat, parameters);
            } catch (const std::exception&) {
                written = false;  // OpenCV's own words name the temporary file, which means nothing to the user
            }
        }
        if (!written)
            throw InputError({path.string(), 0}, "",
                             "cannot be written; may this folder be written to, is the disk full?");
    });
}

}  // namespace caustic
