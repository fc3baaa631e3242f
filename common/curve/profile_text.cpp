#include "curve/profile_text.h"

#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/check.h"
#include "core/text.h"
#include "curve/profile_limits.h"

namespace caustic {

namespace {

constexpr std::string_view closingWord = "closed";
constexpr std::size_t mostPoints = 3 * mostSegments + 1;

std::string_view withoutComment(std::string_view line) { return trimmed(line.substr(0, line.find('#'))); }

// Takes the first line off `text`.
std::string_view takeLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

// Takes the first word off `text`, which doesn't begin with white space.
std::string_view takeWord(std::string_view& text) {
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\f\v"));
    text = trimmed(text.substr(word.size()));
    return word;
}

Real coordinate(std::string_view word, const InputPlace& place) {
    const auto value = parseReal(word);
    if (!value) throw InputError(place, std::string(word), "must be a number that a double can hold");
    if (!std::isfinite(*value)) throw InputError(place, std::string(word), "must be a finite number");
    if (std::abs(*value) > largestCoordinate)
        throw InputError(place, std::string(word), "must not be larger than " + formatReal(largestCoordinate));
    return *value;
}

Vec3 controlPoint(std::string_view line, const InputPlace& place) {
    const std::string whole(line);
    Vec3 point = Vec3::Zero();
    int count = 0;
    while (!line.empty()) {
        if (count == 3) throw InputError(place, whole, "a control point has two or three coordinates");
        point[count++] = coordinate(takeWord(line), place);
    }
    if (count < 2) throw InputError(place, whole, "a control point has two or three coordinates");
    return point;
}

bool isPositiveZero(Real value) { return value == 0 && !std::signbit(value); }

}  // namespace

BezierSpline parseProfileText(std::string_view text, const std::string& file) {
    checkIsText(text, file);
    text = withoutByteOrderMark(text);
    std::vector<Vec3> points;
    points.reserve(std::min(lineOf(text, text.size()), mostPoints));  // growing would hold the points twice
    bool closed = false;
    std::size_t number = 0;
    while (!text.empty()) {
        const std::string_view line = withoutComment(takeLine(text));
        const InputPlace place{file, ++number};
        if (line.empty()) continue;
        if (closed) throw InputError(place, std::string(line), "nothing may follow 'closed'");
        if (line == closingWord) {
            closed = true;
            continue;
        }
        if (points.size() == mostPoints) throw InputError(place, "", "has more than a million segments");
        points.push_back(controlPoint(line, place));
    }
    if (points.empty()) throw InputError({file, 0}, "", "is empty: no control point, no SVG");
    if (points.size() < 4 || points.size() % 3 != 1) {
        throw InputError({file, number}, std::to_string(points.size()) + " points",
                         "n cubic segments need 3n + 1 control points: 4, 7, 10, ...");
    }
    return BezierSpline::fromControlPoints(points, closed);
}

std::string profileText(const BezierSpline& spline) {
    const auto points = spline.controlPoints();
    if (!points) {
        throw InputError(
            {"spline", 0}, "",
            "has segments that don't begin where the one before ends; a file of control points can't say so");
    }
    const bool flat = std::all_of(points->begin(), points->end(), [](const Vec3& p) { return isPositiveZero(p.z()); });
    std::string text = "# Cubic Bezier segments, one after the other: 3n + 1 control points, " +
                       std::string(flat ? "x y" : "x y z") + " a line\n";
    for (const Vec3& point : *points) {
        text += formatReal(point.x()) + ' ' + formatReal(point.y());
        if (!flat) text += ' ' + formatReal(point.z());
        text += '\n';
    }
    if (spline.closed()) text += std::string(closingWord) + '\n';
    return text;
}

void saveProfileText(const BezierSpline& spline, const std::filesystem::path& path) {
    writeTextAtomically(path, profileText(spline));
}

}  // namespace caustic
