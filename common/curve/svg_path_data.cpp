#include "curve/svg_path_data.h"

#include <algorithm>
#include <string>
#include <svgpp/parser/grammar/path_data.hpp>

#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_arc.h"

namespace caustic {

namespace {

using Absolute = svgpp::tag::coordinate::absolute;
using Relative = svgpp::tag::coordinate::relative;

// What svgpp calls for each command. Keeps what the next command may refer to: the current point, the beginning of the
// subpath, and the last control point for the smooth forms.
class SubpathBuilder {
public:
    SubpathBuilder(const SvgTransform& transform, const InputPlace& place) : transform_(transform), place_(place) {}

    std::vector<BezierSpline> takeSplines() { return std::move(splines_); }

    template <typename Kind>
    void path_move_to(Real x, Real y, Kind kind) {
        finishSubpath(false);
        current_ = begin_ = onPage(x, y, kind);
        forgetControls();
    }

    template <typename Kind>
    void path_line_to(Real x, Real y, Kind kind) {
        const Vec2 end = onPage(x, y, kind);
        append(lineToCubic(current_, end));
        forgetControls();
    }

    void path_line_to_ortho(Real coordinate, bool horizontal, Absolute kind) {
        path_line_to(horizontal ? coordinate : current_.x(), horizontal ? current_.y() : coordinate, kind);
    }

    void path_line_to_ortho(Real coordinate, bool horizontal, Relative kind) {
        path_line_to(horizontal ? coordinate : 0, horizontal ? 0 : coordinate, kind);
    }

    template <typename Kind>
    void path_cubic_bezier_to(Real x1, Real y1, Real x2, Real y2, Real x, Real y, Kind kind) {
        appendCubic(onPage(x1, y1, kind), onPage(x2, y2, kind), onPage(x, y, kind));
    }

    template <typename Kind>
    void path_cubic_bezier_to(Real x2, Real y2, Real x, Real y, Kind kind) {
        appendCubic(mirrored(cubicControl_), onPage(x2, y2, kind), onPage(x, y, kind));
    }

    template <typename Kind>
    void path_quadratic_bezier_to(Real x1, Real y1, Real x, Real y, Kind kind) {
        appendQuadratic(onPage(x1, y1, kind), onPage(x, y, kind));
    }

    template <typename Kind>
    void path_quadratic_bezier_to(Real x, Real y, Kind kind) {
        appendQuadratic(mirrored(quadraticControl_), onPage(x, y, kind));
    }

    template <typename Kind>
    void path_elliptical_arc_to(Real rx, Real ry, Real rotation, bool large, bool sweep, Real x, Real y, Kind kind) {
        const Vec2 end = onPage(x, y, kind);
        for (const Real value : {rx, ry, rotation}) checkSize(value);
        for (const CubicPiece& piece : arcToCubics({current_, {rx, ry}, rotation, large, sweep, end})) append(piece);
        forgetControls();
    }

    void path_close_subpath() {
        finishSubpath(true);
        current_ = begin_;
        forgetControls();
    }

    void path_exit() { finishSubpath(false); }

private:
    void checkSize(Real value) const {
        if (std::abs(value) <= largestCoordinate) return;
        throw InputError(place_, formatReal(value),
                         "path data reaches a coordinate larger than " + formatReal(largestCoordinate));
    }

    Vec2 checked(const Vec2& point) const {
        for (const Real coordinate : point) checkSize(coordinate);
        return point;
    }

    Vec2 onPage(Real x, Real y, Absolute) const { return checked({x, y}); }
    Vec2 onPage(Real x, Real y, Relative) const { return checked(current_ + Vec2(x, y)); }

    Vec2 mirrored(const std::optional<Vec2>& control) const { return control ? 2 * current_ - *control : current_; }

    void forgetControls() {
        cubicControl_.reset();
        quadraticControl_.reset();
    }

    void append(const CubicPiece& piece) {
        if (count_ == mostSegments) throw InputError(place_, "", "path has more than a million segments");
        ++count_;
        pieces_.push_back(piece);
        current_ = piece.end;
    }

    void appendCubic(const Vec2& control1, const Vec2& control2, const Vec2& end) {
        append({control1, control2, end});
        forgetControls();
        cubicControl_ = control2;
    }

    void appendQuadratic(const Vec2& control, const Vec2& end) {
        append(quadraticToCubic(current_, control, end));
        forgetControls();
        quadraticControl_ = control;
    }

    // Meets the beginning: by moving an end that rounding alone parts from it, or else by a line.
    void closeSubpath() {
        constexpr Real rounding = 1e-9;
        Real size = begin_.cwiseAbs().maxCoeff();
        for (const CubicPiece& piece : pieces_) size = std::max(size, piece.end.cwiseAbs().maxCoeff());
        if ((current_ - begin_).cwiseAbs().maxCoeff() <= rounding * size) {
            pieces_.back().end = begin_;
        } else {
            append(lineToCubic(current_, begin_));
        }
    }

    void finishSubpath(bool closed) {
        if (pieces_.empty()) return;
        if (closed) closeSubpath();
        std::vector<BezierCurve> segments;
        segments.reserve(pieces_.size());
        Vec3 from = transformed(begin_);
        for (const CubicPiece& piece : pieces_) {
            const Vec3 to = transformed(piece.end);
            segments.emplace_back(
                std::vector<Vec3>{from, transformed(piece.control1), transformed(piece.control2), to});
            from = to;
        }
        splines_.emplace_back(std::move(segments), closed);
        pieces_.clear();
    }

    Vec3 transformed(const Vec2& point) const {
        const Vec2 image = checked(transform_ * point);
        return {image.x(), image.y(), 0};
    }

    SvgTransform transform_;
    InputPlace place_;
    std::vector<BezierSpline> splines_;
    std::vector<CubicPiece> pieces_;  // of the subpath under way, which begins at begin_
    std::size_t count_ = 0;           // of all subpaths
    Vec2 begin_ = Vec2::Zero();
    Vec2 current_ = Vec2::Zero();
    std::optional<Vec2> cubicControl_;
    std::optional<Vec2> quadraticControl_;
};

std::string complaint(std::string_view data, std::string_view rest) {
    constexpr std::string_view moves = "Mm";
    const std::string_view first = trimmed(data);
    if (moves.find(first.front()) == std::string_view::npos) return "path data must begin with M or m";
    if (rest.size() == data.size()) return "malformed path data: M needs two numbers";
    return "malformed path data from here on; a command M L H V C S Q T A Z with its numbers is expected";
}

}  // namespace

std::vector<BezierSpline> parseSvgPathData(std::string_view data, const SvgTransform& transform,
                                           const InputPlace& place) {
    using Grammar = svgpp::path_data_grammar<const char*, SubpathBuilder, Real>;
    static const Grammar grammar;
    const char* rest = data.data();
    const char* const end = rest + data.size();
    SubpathBuilder builder(transform, place);
    boost::spirit::qi::phrase_parse(rest, end, grammar(boost::phoenix::ref(builder)), Grammar::skipper_type());
    if (rest != end) {
        const auto done = static_cast<std::size_t>(rest - data.data());
        throw InputError({place.file, place.line + lineOf(data, done) - 1}, std::string(trimmed(data.substr(done))),
                         complaint(data, data.substr(done)));
    }
    return builder.takeSplines();
}

}  // namespace caustic
