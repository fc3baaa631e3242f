#include "mesh/stl_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "core/error.h"
#include "core/mixer.h"
#include "core/text.h"
#include "mesh/scalar_type.h"

namespace caustic {

namespace {

constexpr std::size_t headerBytes = 80;
constexpr std::size_t firstFacet = headerBytes + 4;
constexpr std::size_t facetBytes = 50;
constexpr std::string_view blanks = " \t\r\n\f\v";

struct Bits {
    std::size_t operator()(const Vec3& v) const {
        std::uint64_t hash = 0;
        for (const Real coordinate : v) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * goldenStep;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

// Triangles one by one; corners at one place become one vertex.
class Soup {
public:
    void add(const std::array<Vec3, 3>& corners) {
        MeshData::Corners numbers;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 place = corners[i] + Vec3::Zero();  // -0 becomes 0
            const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
            const auto [known, isNew] = numbers_.try_emplace(place, next);
            if (isNew) mesh_.positions.push_back(place);
            numbers[i] = known->second;
        }
        mesh_.triangles.push_back(numbers);
    }

    MeshData take(const std::string& file) {
        if (mesh_.triangles.empty()) throw InputError({file, 0}, "", "has no facet");
        return std::move(mesh_);
    }

private:
    MeshData mesh_;
    std::unordered_map<Vec3, std::uint32_t, Bits> numbers_;
};

std::uint64_t announcedFacets(std::string_view content) {
    return static_cast<std::uint64_t>(
        readScalar(content.data() + headerBytes, ScalarType::Uint32, std::endian::little));
}

std::uint64_t announcedSize(std::string_view content) { return firstFacet + facetBytes * announcedFacets(content); }

MeshData parseBinary(std::string_view content, const std::string& file) {
    Soup soup;
    for (std::uint64_t facet = 0; facet < announcedFacets(content); ++facet) {
        const char* bytes = content.data() + firstFacet + facetBytes * facet + 12;  // after the normal
        std::array<Vec3, 3> corners;
        for (Vec3& corner : corners) {
            for (Real& coordinate : corner) {
                coordinate = readScalar(bytes, ScalarType::Float32, std::endian::little);
                bytes += 4;
            }
            if (!corner.allFinite())
                throw InputError({file, 0}, "facet " + std::to_string(facet), "has a coordinate that is not finite");
        }
        soup.add(corners);
    }
    return soup.take(file);
}

class TextReader {
public:
    TextReader(std::string_view content, const std::string& file) : content_(content), file_(file) {}

    MeshData read() {
        do {
            expect("solid");
            at_ = std::min(content_.find_first_of("\r\n", at_), content_.size());  // its name
            readFacets();
        } while (content_.find_first_not_of(blanks, at_) != std::string_view::npos);
        return soup_.take(file_);
    }

private:
    void readFacets() {
        for (std::string text = word(); text != "endsolid"; text = word()) {
            if (text != "facet") fail(text, "must be facet or endsolid");
            expect("normal");
            for (int i = 0; i < 3; ++i) number();
            for (const char* keyword : {"outer", "loop"}) expect(keyword);
            std::array<Vec3, 3> corners;
            for (Vec3& corner : corners) {
                expect("vertex");
                for (Real& coordinate : corner) coordinate = number();
                if (!corner.allFinite()) fail("vertex", "must be finite");
            }
            for (const char* keyword : {"endloop", "endfacet"}) expect(keyword);
            soup_.add(corners);
        }
        at_ = std::min(content_.find_first_of("\r\n", at_), content_.size());
    }

    [[noreturn]] void fail(const std::string& value, const std::string& reason) const {
        const auto end = content_.begin() + static_cast<std::ptrdiff_t>(at_);
        throw InputError({file_, 1 + static_cast<std::size_t>(std::count(content_.begin(), end, '\n'))}, value, reason);
    }

    // In lower case, for some programs write keywords in capitals.
    std::string word() {
        const std::size_t start = std::min(content_.find_first_not_of(blanks, at_), content_.size());
        at_ = std::min(content_.find_first_of(blanks, start), content_.size());
        if (at_ == start) fail("", "ends before its endsolid: it is cut short");
        std::string text(content_.substr(start, at_ - start));
        std::ranges::transform(text, text.begin(),
                               [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
        return text;
    }

    void expect(const std::string& keyword) {
        const std::string found = word();
        if (found != keyword) fail(found, "must be " + keyword);
    }

    Real number() {
        const std::string text = word();
        const std::optional<double> value = parseReal(text);
        if (!value) fail(text, "must be a number");
        return *value;
    }

    std::string_view content_;
    const std::string& file_;
    std::size_t at_ = 0;
    Soup soup_;
};

bool looksLikeText(std::string_view content) {
    constexpr std::size_t looked = 1024;
    const std::size_t first = std::min(content.find_first_not_of(blanks), content.size());
    std::string begin(content.substr(first, 5));
    std::ranges::transform(begin, begin.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return begin == "solid" && content.substr(0, looked).find('\0') == std::string_view::npos;
}

}  // namespace

MeshData parseStl(std::string_view content, const std::string& file) {
    const bool hasHeader = content.size() >= firstFacet;
    if (hasHeader && announcedSize(content) == content.size()) return parseBinary(content, file);
    if (looksLikeText(content)) return TextReader(content, file).read();
    if (!hasHeader) throw InputError({file, 0}, "", "is no STL file, or only its beginning");
    throw InputError({file, 0}, std::to_string(content.size()) + " bytes",
                     "must be " + std::to_string(announcedSize(content)) + " for the " +
                         std::to_string(announcedFacets(content)) +
                         " facets that it announces: it is cut short or damaged");
}

}  // namespace caustic
