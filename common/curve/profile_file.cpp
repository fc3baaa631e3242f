#include "curve/profile_file.h"

#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/profile_text.h"
#include "curve/svg_document.h"

namespace caustic {

namespace {

BezierSpline turnedOver(const BezierSpline& spline, Real bottom) {
    std::vector<BezierCurve> segments;
    segments.reserve(spline.segments().size());
    for (const BezierCurve& segment : spline.segments()) {
        std::vector<Vec3> points = segment.controlPoints();
        for (Vec3& point : points) point.y() = bottom - point.y();
        segments.emplace_back(std::move(points));
    }
    return BezierSpline(std::move(segments), spline.closed());
}

BezierSpline svgProfile(const SvgDocument& document, const std::string& choice) {
    const SvgPathElement& path = chosenPath(document, choice);
    const std::vector<BezierSpline> splines = svgSplines(path);
    if (splines.size() != 1) {
        throw InputError({document.file, path.line}, path.id,
                         "path has " + std::to_string(splines.size()) + " subpaths; a profile is one curve");
    }
    return turnedOver(splines.front(), document.bottom);
}

// The name without its choice, and the choice.
std::pair<std::string, std::string> splitName(const std::string& name) {
    std::error_code ignored;
    const std::size_t mark = name.rfind('#');
    if (mark == std::string::npos || std::filesystem::exists(name, ignored)) return {name, ""};
    return {name.substr(0, mark), name.substr(mark + 1)};
}

}  // namespace

ProfileFile readProfileFile(const std::string& name) {
    const auto [file, choice] = splitName(name);
    ProfileFile profile{file, choice, readTextFile(file, mostProfileBytes)};
    profile.svg = trimmed(withoutByteOrderMark(profile.text)).starts_with('<');
    if (!profile.svg && !choice.empty())
        throw InputError({file, 0}, choice, "a file of control points has one curve, nothing to choose");
    return profile;
}

BezierSpline loadProfile(const std::string& name) {
    const ProfileFile profile = readProfileFile(name);
    if (!profile.svg) return parseProfileText(profile.text, profile.file);
    return svgProfile(parseSvg(profile.text, profile.file), profile.choice);
}

}  // namespace caustic
