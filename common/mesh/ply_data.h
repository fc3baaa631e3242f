#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/ply_header.h"

namespace caustic {

/// Reads the data of a PLY file, property by property, whatever the header says they are written in.
class PlyData {
public:
    /// @param file  what an error's place is called
    PlyData(std::string_view content, const PlyHeader& header, const std::string& file);

    /// The values of the next property: one, or those of a list.
    /// @param element  whose property it is, for errors
    /// @param number   which of them, from 0
    /// @return valid until the next call
    /// @throws InputError when they are not there, or no numbers (in a text, with the line)
    const std::vector<Real>& next(const PlyProperty& property, const std::string& element, std::uint64_t number);

    /// Throws InputError unless all has been read: a file that holds more than it announces was announced wrongly.
    void checkEnd() const;

    /// Throws InputError for what is wrong with the property that was read last.
    [[noreturn]] void fail(const std::string& value, const std::string& reason) const;

private:
    void readText(const PlyProperty& property);
    void readBinary(const PlyProperty& property);
    std::string_view word();
    Real textNumber(ScalarType type);
    Real binaryNumber(ScalarType type);
    std::size_t listLength(Real count, std::size_t leastBytes) const;
    [[noreturn]] void failCutShort() const;

    std::string_view content_;
    const std::string& file_;
    PlyFormat format_;
    std::endian order_;
    std::size_t at_;
    std::vector<Real> values_;
    const std::string* element_ = nullptr;
    std::uint64_t number_ = 0;
};

}  // namespace caustic
