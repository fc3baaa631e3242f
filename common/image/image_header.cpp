#include "image/image_header.h"

#include <fstream>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n"sv;
constexpr std::string_view jpegSignature = "\xff\xd8\xff"sv;
constexpr std::string_view exrSignature = "\x76\x2f\x31\x01"sv;
constexpr std::string_view radianceSignature = "#?"sv;
constexpr std::size_t longestText = 4096;  // of a name or line in a header

// Reads a binary header piece by piece; running out of bytes is the user's broken file.
class HeaderReader {
public:
    explicit HeaderReader(const std::filesystem::path& path) : path_(path.string()), file_(open(path)) {}

    [[noreturn]] void fail(const std::string& reason, const std::string& value = "") const {
        throw InputError({path_, 0}, value, reason);
    }

    std::string bytes(std::size_t count) {
        std::string text(count, '\0');
        file_.read(text.data(), static_cast<std::streamsize>(count));
        if (static_cast<std::size_t>(file_.gcount()) != count) fail("ends within its header; is it truncated?");
        return text;
    }

    std::uint32_t bigEndian(std::size_t count) { return number(bytes(count), 0); }

    std::int32_t littleEndian32() {
        const std::string text = bytes(4);
        return static_cast<std::int32_t>(number({text.rbegin(), text.rend()}, 0));
    }

    // Up to, without, the end mark.
    std::string textUntil(char end) {
        std::string text;
        for (char c = bytes(1)[0]; c != end; c = bytes(1)[0]) {
            text += c;
            if (text.size() > longestText) fail("has a header that is no image's", text);
        }
        return text;
    }

    void skip(std::size_t count) { file_.ignore(static_cast<std::streamsize>(count)); }

    // The signature that the file starts with is left read; otherwise the file stands at its start again.
    bool startsWith(std::string_view signature) {
        std::string text(signature.size(), '\0');
        file_.read(text.data(), static_cast<std::streamsize>(text.size()));
        if (file_ && text == signature) return true;
        file_.clear();
        file_.seekg(0);
        return false;
    }

private:
    static std::ifstream open(const std::filesystem::path& path) {
        const InputPlace place{path.string(), 0};
        std::error_code failure;
        const auto status = std::filesystem::status(path, failure);
        if (!std::filesystem::exists(status)) throw InputError(place, "", "no such file");
        if (std::filesystem::is_directory(status)) throw InputError(place, "", "is a folder, not a file");
        std::ifstream file(path, std::ios::binary);
        if (!file) throw InputError(place, "", "cannot be opened for reading");
        const bool hasByte = file.peek() != std::ifstream::traits_type::eof();
        if (file.bad()) throw InputError(place, "", "cannot be read");
        if (!hasByte) throw InputError(place, "", "is empty");
        return file;
    }

    static std::uint32_t number(const std::string& text, std::uint32_t start) {
        for (const char c : text) start = start << 8 | static_cast<unsigned char>(c);
        return start;
    }

    std::string path_;
    std::ifstream file_;
};

// Portable Network Graphics, 5.2 and 11.2.2: the IHDR chunk comes first.
ImageHeader readPng(HeaderReader& reader) {
    reader.skip(4);
    if (reader.bytes(4) != "IHDR") reader.fail("is a damaged PNG: it doesn't start with its size");
    const std::uint32_t width = reader.bigEndian(4);
    return {ImageFormat::Png, width, reader.bigEndian(4)};
}

// ITU-T T.81, B.2: segments until the frame header, which is SOF0 to SOF15 but for the three codes in between.
ImageHeader readJpeg(HeaderReader& reader) {
    std::uint32_t marker = reader.bigEndian(1);  // the signature's last byte began it
    while (true) {
        while (marker == 0xff) marker = reader.bigEndian(1);
        const std::uint32_t length = reader.bigEndian(2);
        const bool isFrame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame) break;
        if (length < 2) reader.fail("is a damaged JPEG: a segment has no length");
        reader.skip(length - 2);
        if (reader.bigEndian(1) != 0xff) reader.fail("is a damaged JPEG: a segment doesn't end where it says");
        marker = reader.bigEndian(1);
    }
    reader.skip(1);  // bits per sample
    const std::uint32_t height = reader.bigEndian(2);
    return {ImageFormat::Jpeg, reader.bigEndian(2), height};
}

// OpenEXR file layout: attributes (name, type, length, value) until an empty name.
ImageHeader readExr(HeaderReader& reader) {
    reader.skip(4);  // version and flags
    for (std::string name = reader.textUntil('\0'); !name.empty(); name = reader.textUntil('\0')) {
        const std::string type = reader.textUntil('\0');
        const std::int32_t length = reader.littleEndian32();
        if (length < 0) reader.fail("is a damaged OpenEXR file: an attribute has a negative length", name);
        if (name != "dataWindow" || type != "box2i") {
            reader.skip(static_cast<std::size_t>(length));
            continue;
        }
        const std::int64_t left = reader.littleEndian32();
        const std::int64_t top = reader.littleEndian32();
        const std::int64_t right = reader.littleEndian32();
        const std::int64_t bottom = reader.littleEndian32();
        return {ImageFormat::OpenExr, right - left + 1, bottom - top + 1};
    }
    reader.fail("is a damaged OpenEXR file: it has no dataWindow");
}

// Ward 1994, "Real pixels": lines until an empty one, then "-Y height +X width".
ImageHeader readRadiance(HeaderReader& reader) {
    while (!reader.textUntil('\n').empty()) continue;
    const std::string line = reader.textUntil('\n');
    const std::size_t x = line.find(" +X ");
    if (!line.starts_with("-Y ") || x == std::string::npos)
        reader.fail("is a Radiance picture of an unusual orientation; only '-Y height +X width' is read", line);
    const auto height = parseInteger(line.substr(3, x - 3));
    const auto width = parseInteger(line.substr(x + 4));
    if (!height || !width) reader.fail("is a damaged Radiance picture: its size is no pair of numbers", line);
    return {ImageFormat::Radiance, *width, *height};
}

}  // namespace

ImageHeader readImageHeader(const std::filesystem::path& path) {
    HeaderReader reader(path);
    if (reader.startsWith(pngSignature)) return readPng(reader);
    if (reader.startsWith(jpegSignature)) return readJpeg(reader);
    if (reader.startsWith(exrSignature)) return readExr(reader);
    if (reader.startsWith(radianceSignature)) return readRadiance(reader);
    reader.fail("is no image that the course reads: PNG, JPEG, OpenEXR or Radiance");
}

}  // namespace caustic
