#include "mesh/ply_data.h"

#include <algorithm>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

}  // namespace

PlyData::PlyData(std::string_view content, const PlyHeader& header, const std::string& file)
    : content_(content),
      file_(file),
      format_(header.format),
      order_(header.format == PlyFormat::BigEndian ? std::endian::big : std::endian::little),
      at_(header.size) {}

const std::vector<Real>& PlyData::next(const PlyProperty& property, const std::string& element, std::uint64_t number) {
    element_ = &element;
    number_ = number;
    values_.clear();
    if (format_ == PlyFormat::Text) {
        readText(property);
    } else {
        readBinary(property);
    }
    return values_;
}

void PlyData::readText(const PlyProperty& property) {
    const std::size_t count = property.countType ? listLength(textNumber(*property.countType), 2) : 1;
    for (std::size_t i = 0; i < count; ++i) values_.push_back(textNumber(property.type));
}

void PlyData::readBinary(const PlyProperty& property) {
    const std::size_t size = sizeOf(property.type);
    const std::size_t count = property.countType ? listLength(binaryNumber(*property.countType), size) : 1;
    for (std::size_t i = 0; i < count; ++i) values_.push_back(binaryNumber(property.type));
}

// Bounded by what is left of the file, so that no announcement makes memory grow.
std::size_t PlyData::listLength(Real count, std::size_t leastBytes) const {
    if (count < 0) fail(formatReal(count), "is no length of a list");
    if (count > static_cast<Real>((content_.size() - at_ + 1) / leastBytes)) failCutShort();
    return static_cast<std::size_t>(count);
}

std::string_view PlyData::word() {
    const std::size_t start = content_.find_first_not_of(blanks, at_);
    if (start == std::string_view::npos) failCutShort();
    at_ = std::min(content_.find_first_of(blanks, start), content_.size());
    return content_.substr(start, at_ - start);
}

Real PlyData::textNumber(ScalarType type) {
    const std::string_view text = word();
    if (isReal(type)) {
        const std::optional<double> value = parseReal(text);
        if (!value) fail(std::string(text), "must be a number");
        return *value;
    }
    const std::optional<long long> value = parseInteger(text);
    if (!value) fail(std::string(text), "must be an integer");
    return static_cast<Real>(*value);
}

Real PlyData::binaryNumber(ScalarType type) {
    const std::size_t size = sizeOf(type);
    if (content_.size() - at_ < size) failCutShort();
    const Real value = readScalar(content_.data() + at_, type, order_);
    at_ += size;
    return value;
}

void PlyData::checkEnd() const {
    if (format_ == PlyFormat::Text) {
        const std::size_t next = content_.find_first_not_of(blanks, at_);
        if (next == std::string_view::npos) return;
        const std::size_t end = std::min(content_.find_first_of(blanks, next), content_.size());
        throw InputError(
            {file_, 1 + static_cast<std::size_t>(
                            std::count(content_.begin(), content_.begin() + static_cast<std::ptrdiff_t>(next), '\n'))},
            std::string(content_.substr(next, end - next)), "is more than the header announces");
    }
    if (at_ == content_.size()) return;
    throw InputError({file_, 0}, std::to_string(content_.size() - at_) + " bytes",
                     "are more than the header announces");
}

void PlyData::failCutShort() const {
    throw InputError({file_, 0}, *element_ + " " + std::to_string(number_), "is missing: the file is cut short");
}

void PlyData::fail(const std::string& value, const std::string& reason) const {
    std::size_t line = 0;
    if (format_ == PlyFormat::Text) {
        const auto end = content_.begin() + static_cast<std::ptrdiff_t>(at_);
        line = 1 + static_cast<std::size_t>(std::count(content_.begin(), end, '\n'));
    }
    throw InputError({file_, line}, value, *element_ + " " + std::to_string(number_) + ": " + reason);
}

}  // namespace caustic
