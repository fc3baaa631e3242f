#include "mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

constexpr std::array<std::pair<std::string_view, ScalarType>, 16> typeNames = {{{"char", ScalarType::Int8},
                                                                                {"uchar", ScalarType::Uint8},
                                                                                {"short", ScalarType::Int16},
                                                                                {"ushort", ScalarType::Uint16},
                                                                                {"int", ScalarType::Int32},
                                                                                {"uint", ScalarType::Uint32},
                                                                                {"float", ScalarType::Float32},
                                                                                {"double", ScalarType::Float64},
                                                                                {"int8", ScalarType::Int8},
                                                                                {"uint8", ScalarType::Uint8},
                                                                                {"int16", ScalarType::Int16},
                                                                                {"uint16", ScalarType::Uint16},
                                                                                {"int32", ScalarType::Int32},
                                                                                {"uint32", ScalarType::Uint32},
                                                                                {"float32", ScalarType::Float32},
                                                                                {"float64", ScalarType::Float64}}};

class HeaderReader {
public:
    HeaderReader(std::string_view content, const std::string& file) : content_(content), file_(file) {}

    PlyHeader read() {
        if (!content_.starts_with("ply")) fail("", "is no PLY file: it doesn't begin with ply");
        takeLine();
        if (rest_ != "ply") fail(rest_, "is no PLY file: its first line is not ply");
        bool formatKnown = false;
        for (takeLine(); rest_ != "end_header"; takeLine()) {
            const std::string_view keyword = takeWord();
            if (keyword == "format") {
                readFormat();
                formatKnown = true;
            } else if (keyword == "element") {
                readElement();
            } else if (keyword == "property") {
                readProperty();
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                fail(keyword, "is no statement of a PLY header");
            }
        }
        if (!formatKnown) fail("", "has no format line before its end_header");
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(std::string_view value, const std::string& reason) const {
        throw InputError({file_, line_}, std::string(value), reason);
    }

    // The next line, trimmed. Binary data may follow at once, so nothing beyond its line feed belongs to the header.
    void takeLine() {
        ++line_;
        const std::size_t end = content_.find('\n', header_.size);
        if (end == std::string_view::npos) {
            const bool oldMac = content_.substr(header_.size).find('\r') != std::string_view::npos;
            fail("", oldMac ? "ends its header's lines with CR alone; must be LF or CR LF"
                            : "has no end_header: it is cut short");
        }
        rest_ = trimmed(content_.substr(header_.size, end - header_.size));
        header_.size = end + 1;
    }

    std::string_view takeWord() {
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t"));
        rest_ = trimmed(rest_.substr(word.size()));
        return word;
    }

    void readFormat() {
        const std::string_view format = takeWord();
        if (format == "ascii") {
            header_.format = PlyFormat::Text;
        } else if (format == "binary_little_endian") {
            header_.format = PlyFormat::LittleEndian;
        } else if (format == "binary_big_endian") {
            header_.format = PlyFormat::BigEndian;
        } else {
            fail(format, "is no format of a PLY file");
        }
    }

    void readElement() {
        const std::string name(takeWord());
        const auto count = parseInteger(rest_);
        if (!count || *count < 0) fail(rest_, "is no number of elements");
        const bool twice = std::ranges::find(header_.elements, name, &PlyElement::name) != header_.elements.end();
        if (twice) fail(name, "is an element that comes twice");
        header_.elements.push_back({name, static_cast<std::uint64_t>(*count), {}});
    }

    void readProperty() {
        if (header_.elements.empty()) fail("property", "belongs to no element");
        PlyProperty property;
        std::string_view type = takeWord();
        if (type == "list") {
            property.countType = typeOf(takeWord());
            if (isReal(*property.countType)) fail("list", "has a count that is no integer");
            type = takeWord();
        }
        property.type = typeOf(type);
        property.name = rest_;
        PlyElement& element = header_.elements.back();
        if (property.name.empty()) fail("property", "has no name");
        if (element.find(property.name)) fail(property.name, "is a property that comes twice");
        element.properties.push_back(std::move(property));
    }

    ScalarType typeOf(std::string_view name) const {
        const auto* const found = std::ranges::find(typeNames, name, &std::pair<std::string_view, ScalarType>::first);
        if (found == typeNames.end()) fail(name, "is no type of a PLY property");
        return found->second;
    }

    std::string_view content_;
    const std::string& file_;
    PlyHeader header_;
    std::size_t line_ = 0;
    std::string_view rest_;  // of the line
};

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view wanted) const {
    const auto found = std::ranges::find(properties, wanted, &PlyProperty::name);
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
}

PlyHeader parsePlyHeader(std::string_view content, const std::string& file) {
    return HeaderReader(content, file).read();
}

}  // namespace caustic
