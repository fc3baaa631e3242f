#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/scalar_type.h"

namespace caustic {

/// A value of an element, or a list of values with their number before them.
struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::Float32;
    std::optional<ScalarType> countType;  ///< of a list only
};

/// A kind of things that a PLY file lists: vertices, faces and whatever else.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The number of the property of that name.
    std::optional<std::size_t> find(std::string_view name) const;
};

/// How the data after the header are written.
enum class PlyFormat { Text, LittleEndian, BigEndian };

/// What the beginning of a PLY file announces.
struct PlyHeader {
    PlyFormat format = PlyFormat::Text;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  ///< bytes of the header: where the data begin
};

/// Reads the header, whose lines end in LF or CR LF.
/// Source: Turk 1994, The PLY Polygon File Format.
/// @param file  what an error's place is called
/// @throws InputError with the line: no PLY, no end, an unknown format, type or statement, a number of elements that is
///         none, a name that comes twice
PlyHeader parsePlyHeader(std::string_view content, const std::string& file);

}  // namespace caustic
