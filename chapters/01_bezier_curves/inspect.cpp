#include "inspect.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/error.h"
#include "curve/profile_file.h"
#include "curve/profile_text.h"
#include "curve/svg_document.h"

namespace caustic {

namespace {

using Json = nlohmann::ordered_json;

// Lengths are computed to this share of the size of the subpath.
constexpr Real lengthTolerance = 1e-12;

// Two coordinates where the file has two.
enum class Dimensions { Two, Three };

Json pointJson(const Vec3& point, Dimensions dimensions) {
    if (dimensions == Dimensions::Two) return {point.x(), point.y()};
    return {point.x(), point.y(), point.z()};
}

// Ids may hold any bytes; those that are no UTF-8 become replacement characters.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Writes JSON piece by piece, a line for each segment and joint: a path of a million segments would not fit into memory
// as one tree, nor could a person read it with a line for each number.
class Writer {
public:
    explicit Writer(std::ostream& out) : out_(&out) {}

    void open(const std::string& key, char bracket) {
        startItem(key);
        *out_ << bracket;
        first_ = true;
        indent_ += 2;
    }

    void close(char bracket) {
        indent_ -= 2;
        if (!first_) startLine();
        *out_ << bracket;
        first_ = false;
    }

    void item(const std::string& key, const Json& value) {
        startItem(key);
        *out_ << dumped(value);
    }

private:
    void startItem(const std::string& key) {
        if (!first_) *out_ << ',';
        if (indent_ > 0) startLine();
        if (!key.empty()) *out_ << dumped(key) << ": ";
        first_ = false;
    }

    void startLine() { *out_ << '\n' << std::string(indent_, ' '); }

    std::ostream* out_;
    std::size_t indent_ = 0;
    bool first_ = true;
};

Json jointJson(const Joint& joint) {
    return {{"continuity", name(joint.continuity)},
            {"distance", joint.distance},
            {"angle", joint.angle ? Json(*joint.angle) : Json()},
            {"derivativeDifference", joint.derivativeDifference}};
}

Json boundsJson(const Bounds3& box, Dimensions dimensions) {
    return {{"min", pointJson(box.min(), dimensions)}, {"max", pointJson(box.max(), dimensions)}};
}

// A spline with what is computed of it.
struct Measured {
    const BezierSpline* spline;
    LengthEstimate length;
    Bounds3 bounds;
};

Measured measured(const BezierSpline& spline) {
    const Bounds3 box = spline.bounds();
    const Real size = std::max(box.diagonal().norm(), std::numeric_limits<Real>::min());
    return {&spline, spline.length(lengthTolerance * size), box};
}

void writeSubpath(const Measured& subpath, Dimensions dimensions, Writer& writer) {
    writer.open("", '{');
    writer.item("closed", subpath.spline->closed());
    writer.item("length", subpath.length.length);
    writer.item("lengthError", subpath.length.error);
    writer.item("bounds", boundsJson(subpath.bounds, dimensions));
    writer.open("segments", '[');
    for (const BezierCurve& segment : subpath.spline->segments()) {
        Json points = Json::array();
        for (const Vec3& point : segment.controlPoints()) points.push_back(pointJson(point, dimensions));
        writer.item("", points);
    }
    writer.close(']');
    writer.open("joints", '[');
    for (const Joint& joint : subpath.spline->joints()) writer.item("", jointJson(joint));
    writer.close(']');
    writer.close('}');
}

// What all subpaths together come to, and then each of them.
void writeSplines(const std::vector<BezierSpline>& splines, Dimensions dimensions, Writer& writer) {
    std::vector<Measured> subpaths;
    Real length = 0;
    Real error = 0;
    Bounds3 box;
    for (const BezierSpline& spline : splines) {
        subpaths.push_back(measured(spline));
        length += subpaths.back().length.length;
        error += subpaths.back().length.error;
        box.extend(subpaths.back().bounds);
    }
    error += static_cast<Real>(splines.size()) * std::numeric_limits<Real>::epsilon() * length;
    writer.item("length", length);
    writer.item("lengthError", error);
    writer.item("bounds", box.isEmpty() ? Json() : boundsJson(box, dimensions));
    writer.open("subpaths", '[');
    for (const Measured& subpath : subpaths) writeSubpath(subpath, dimensions, writer);
    writer.close(']');
}

void writeHead(const std::string& file, const char* kind, const char* units, Writer& writer) {
    const JointTolerance tolerance;
    writer.open("", '{');
    writer.item("file", file);
    writer.item("kind", kind);
    writer.item("coordinates", units);
    writer.item("jointTolerance",
                {{"distance", tolerance.distance}, {"angle", tolerance.angle}, {"derivative", tolerance.derivative}});
    writer.open("paths", '[');
}

void writeTail(Writer& writer, std::ostream& out) {
    writer.close(']');
    writer.close('}');
    out << '\n';
}

Json matrixJson(const SvgTransform& transform) {
    const auto& m = transform.matrix();
    return {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)};
}

std::vector<const SvgPathElement*> shownPaths(const SvgDocument& document, const std::string& choice) {
    if (!choice.empty()) return {&chosenPath(document, choice)};
    std::vector<const SvgPathElement*> shown;
    for (const SvgPathElement& path : document.paths) {
        if (path.drawn) shown.push_back(&path);
    }
    if (shown.empty()) chosenPath(document, choice);  // which says why
    return shown;
}

void inspectSvg(const SvgDocument& document, const std::string& choice, std::ostream& out) {
    const auto shown = shownPaths(document, choice);
    // All are read before the first is written, and not kept: together they may be large.
    for (const SvgPathElement* path : shown) svgSplines(*path);

    Writer writer(out);
    writeHead(document.file, "svg", "user units of the outermost svg element, y down", writer);
    for (const SvgPathElement* path : shown) {
        writer.open("", '{');
        writer.item("id", path->id.empty() ? Json() : Json(path->id));
        writer.item("line", path->line);
        writer.item("drawn", path->drawn);
        writer.item("transform", matrixJson(path->transform));
        writeSplines(svgSplines(*path), Dimensions::Two, writer);
        writer.close('}');
    }
    writeTail(writer, out);
}

void inspectText(const std::string& text, const std::string& file, std::ostream& out) {
    const BezierSpline spline = parseProfileText(text, file);
    const Bounds3 box = spline.bounds();
    const bool flat = box.min().z() == 0 && box.max().z() == 0;
    Writer writer(out);
    writeHead(file, "control points", "the file's own", writer);
    writer.open("", '{');
    writer.item("id", Json());
    writeSplines({spline}, flat ? Dimensions::Two : Dimensions::Three, writer);
    writer.close('}');
    writeTail(writer, out);
}

}  // namespace

void inspectProfile(const std::string& name, std::ostream& out) {
    const ProfileFile profile = readProfileFile(name);
    if (profile.svg) {
        inspectSvg(parseSvg(profile.text, profile.file), profile.choice, out);
    } else {
        inspectText(profile.text, profile.file, out);
    }
    out.flush();
    if (!out) throw InputError({"standard output", 0}, "", "cannot be written; is the disk full?");
}

}  // namespace caustic
