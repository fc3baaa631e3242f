#include "mesh/ply_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

struct ScalarType {
    std::string_view name;
    std::size_t size;
    bool real;
};
constexpr std::array<ScalarType, 16> scalarTypes = {{{"char", 1, false},
                                                     {"uchar", 1, false},
                                                     {"short", 2, false},
                                                     {"ushort", 2, false},
                                                     {"int", 4, false},
                                                     {"uint", 4, false},
                                                     {"float", 4, true},
                                                     {"double", 8, true},
                                                     {"int8", 1, false},
                                                     {"uint8", 1, false},
                                                     {"int16", 2, false},
                                                     {"uint16", 2, false},
                                                     {"int32", 4, false},
                                                     {"uint32", 4, false},
                                                     {"float32", 4, true},
                                                     {"float64", 8, true}}};

// A value, or a list of values with their number before them.
struct Property {
    std::size_t valueSize = 0;
    std::size_t countSize = 0;  // 0 for a single value
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Format { Text, LittleEndian, BigEndian };

struct Header {
    Format format = Format::Text;
    std::vector<Element> elements;
    std::size_t size = 0;
};

class PlyCheck {
public:
    PlyCheck(std::string_view content, const std::filesystem::path& path) : content_(content), path_(path) {}

    void run() {
        const Header header = readHeader();
        at_ = header.size;
        for (const Element& element : header.elements) {
            for (std::uint64_t i = 0; i < element.count; ++i) {
                for (const Property& property : element.properties) {
                    if (!skip(property, header.format))
                        refuse(element.name + " " + std::to_string(i), "is missing: the file is cut short");
                }
            }
        }
    }

private:
    [[noreturn]] void refuse(const std::string& value, const std::string& reason) const {
        throw InputError({path_.string(), 0}, value, reason);
    }

    std::size_t sizeOf(const std::string& type, bool real) const {
        for (const ScalarType& one : scalarTypes) {
            if (one.name == type && (real || !one.real)) return one.size;
        }
        refuse(type, "is no type of a PLY property");
    }

    Header readHeader() const {
        constexpr std::string_view last = "end_header";
        const std::size_t end = content_.find(last);
        const std::size_t newLine = end == std::string_view::npos ? end : content_.find('\n', end);
        if (newLine == std::string_view::npos) refuse("", "has no end_header: no PLY file, or only its beginning");
        Header header;
        header.size = newLine + 1;
        std::istringstream lines{std::string(content_.substr(0, end))};
        for (std::string line; std::getline(lines, line);) readLine(line, header);
        return header;
    }

    void readLine(const std::string& line, Header& header) const {
        std::istringstream words(line);
        std::string kind;
        std::string first;
        std::string second;
        words >> kind >> first >> second;
        if (kind == "format") {
            if (first == "binary_little_endian") header.format = Format::LittleEndian;
            if (first == "binary_big_endian") header.format = Format::BigEndian;
        } else if (kind == "element") {
            const auto count = parseInteger(second);
            if (!count || *count < 0) refuse(second, "is no number of elements");
            header.elements.push_back({first, static_cast<std::uint64_t>(*count), {}});
        } else if (kind == "property") {
            if (header.elements.empty()) refuse("property", "belongs to no element");
            std::string value = first;
            if (first == "list") words >> value;
            const std::size_t countSize = first == "list" ? sizeOf(second, false) : 0;
            header.elements.back().properties.push_back({sizeOf(value, true), countSize});
        }
    }

    // Whether it was there.
    bool skip(const Property& property, Format format) {
        if (format == Format::Text) {
            const auto value = word();
            if (!value || property.countSize == 0) return value.has_value();
            const auto count = parseInteger(*value);
            if (!count || *count < 0) refuse(std::string(*value), "is no length of a list");
            for (long long i = 0; i < *count; ++i) {
                if (!word()) return false;
            }
            return true;
        }
        std::uint64_t count = 1;
        if (property.countSize > 0) {
            if (content_.size() - at_ < property.countSize) return false;
            count = unsignedAt(property.countSize, format);
            at_ += property.countSize;
        }
        if ((content_.size() - at_) / property.valueSize < count) return false;
        at_ += count * property.valueSize;
        return true;
    }

    std::optional<std::string_view> word() {
        constexpr std::string_view blanks = " \t\r\n";
        const std::size_t start = content_.find_first_not_of(blanks, at_);
        if (start == std::string_view::npos) return std::nullopt;
        at_ = std::min(content_.find_first_of(blanks, start), content_.size());
        return content_.substr(start, at_ - start);
    }

    std::uint64_t unsignedAt(std::size_t size, Format format) const {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t place = format == Format::BigEndian ? i : size - 1 - i;
            value = value << 8 | static_cast<unsigned char>(content_[at_ + place]);
        }
        return value;
    }

    std::string_view content_;
    const std::filesystem::path& path_;
    std::size_t at_ = 0;
};

}  // namespace

void checkPly(std::string_view content, const std::filesystem::path& path) { PlyCheck(content, path).run(); }

}  // namespace caustic
