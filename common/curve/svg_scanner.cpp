#include "curve/svg_scanner.h"

#include <cmath>

#include "core/text.h"
#include "curve/profile_limits.h"

namespace caustic {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isSign(char c) { return c == '+' || c == '-'; }

}  // namespace

void SvgScanner::skipSpace() {
    while (isSpace(next())) ++place_;
}

void SvgScanner::skipSeparator() {
    skipSpace();
    if (take(',')) skipSpace();
}

bool SvgScanner::take(char character) {
    if (place_ == text_.size() || text_[place_] != character) return false;
    ++place_;
    return true;
}

std::string_view SvgScanner::takeWord() {
    const std::size_t begin = place_;
    while (isLetter(next()) || isDigit(next())) ++place_;
    return text_.substr(begin, place_ - begin);
}

// Where the digits end that begin there.
std::size_t SvgScanner::takeDigits(std::size_t from) const {
    while (from < text_.size() && isDigit(text_[from])) ++from;
    return from;
}

std::optional<Real> SvgScanner::takeNumber() {
    const auto at = [&](std::size_t place) { return place < text_.size() ? text_[place] : '\0'; };
    const std::size_t begin = place_ + (isSign(next()) ? 1 : 0);
    std::size_t end = takeDigits(begin);
    std::size_t digits = end - begin;
    if (at(end) == '.') {
        const std::size_t fraction = end + 1;
        end = takeDigits(fraction);
        digits += end - fraction;
    }
    if (digits == 0) return std::nullopt;
    if (at(end) == 'e' || at(end) == 'E') {
        const std::size_t exponent = end + (isSign(at(end + 1)) ? 2 : 1);
        if (isDigit(at(exponent))) end = takeDigits(exponent);
    }
    const std::optional<Real> value = parseReal(text_.substr(place_, end - place_));
    if (value) place_ = end;
    return value;
}

std::optional<bool> SvgScanner::takeFlag() {
    if (take('0')) return false;
    if (take('1')) return true;
    return std::nullopt;
}

std::optional<Real> svgUserUnits(std::string_view text) {
    SvgScanner scanner(trimmed(text));
    const std::optional<Real> value = scanner.takeNumber();
    const std::string_view unit = scanner.takeWord();
    const bool plain = scanner.rest().empty() && (unit.empty() || unit == "px");
    return value && plain && std::abs(*value) <= largestCoordinate ? value : std::nullopt;
}

}  // namespace caustic
