#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "math/real.h"

namespace caustic {

/// Goes over the text of an SVG attribute: the numbers, flags and separators that path data, transforms and viewBox
/// share. What is not there is not taken, so the place stays where a complaint should point to.
///
/// Numbers by the rule of SVG 2, 9.3.9, and the older one of SVG 1.1, 8.3.9, which allows "1." too: a number ends where
/// the next character can't belong to it, so "1-2" and ".5.5" are two.
class SvgScanner {
public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    /// What is left to read.
    std::string_view rest() const { return text_.substr(place_); }
    /// How much has been read.
    std::size_t place() const { return place_; }
    /// Goes back to a place.
    void goTo(std::size_t place) { place_ = place; }
    /// The next character, or a zero byte at the end.
    char next() const { return place_ < text_.size() ? text_[place_] : '\0'; }

    /// Skips space, tab, line feed, carriage return and form feed.
    void skipSpace();
    /// Skips white space with at most one comma in it.
    void skipSeparator();
    /// Takes the character if it comes next.
    bool take(char character);
    /// Takes letters and digits, as many as come: a function's name or a unit.
    std::string_view takeWord();
    /// Takes a number; nothing when none comes, or one too large for a double. One too small is 0.
    std::optional<Real> takeNumber();
    /// Takes a 0 or a 1, even when a digit follows.
    std::optional<bool> takeFlag();

private:
    std::size_t takeDigits(std::size_t from) const;

    std::string_view text_;
    std::size_t place_ = 0;
};

/// A length in user units: a plain number, or one in px, which is the same. Nothing for anything else, and beyond
/// largestCoordinate.
std::optional<Real> svgUserUnits(std::string_view text);

}  // namespace caustic
