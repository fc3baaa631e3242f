#include "curve/svg_path_data.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_arc.h"
#include "curve/svg_scanner.h"

namespace caustic {

namespace {

// A command's letter in upper case, how many numbers it takes, and whether they count from the current point.
struct Command {
    char letter;
    std::size_t count;
    bool relative;
};

std::optional<Command> commandOf(char letter) {
    constexpr std::string_view letters = "MLHVCSQTAZ";
    constexpr std::array<std::size_t, letters.size()> counts = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};
    const bool relative = letter >= 'a' && letter <= 'z';
    const char upper = relative ? static_cast<char>(letter - 'a' + 'A') : letter;
    const std::size_t found = letters.find(upper);
    if (found == std::string_view::npos) return std::nullopt;
    return Command{upper, counts[found], relative};
}

using Numbers = std::array<Real, 7>;

// Draws the commands. Keeps what the next command may refer to: the current point, the beginning of the subpath, and
// the last control point for the smooth forms.
class SubpathBuilder {
public:
    SubpathBuilder(const SvgTransform& transform, const InputPlace& place) : transform_(transform), place_(place) {}

    std::vector<BezierSpline> takeSplines() {
        finishSubpath(false);
        return std::move(splines_);
    }

    void draw(const Command& command, const Numbers& n) {
        const Vec2 from = command.relative ? current_ : Vec2::Zero();
        const auto point = [&](std::size_t i) { return checked(from + Vec2(n[i], n[i + 1])); };
        switch (command.letter) {
            case 'M':
                return moveTo(point(0));
            case 'L':
                return lineTo(point(0));
            case 'H':
                return lineTo(checked({from.x() + n[0], current_.y()}));
            case 'V':
                return lineTo(checked({current_.x(), from.y() + n[0]}));
            case 'C':
                return cubicTo(point(0), point(2), point(4));
            case 'S':
                return cubicTo(mirrored(cubicControl_), point(0), point(2));
            case 'Q':
                return quadraticTo(point(0), point(2));
            case 'T':
                return quadraticTo(mirrored(quadraticControl_), point(0));
            case 'A':
                return arcTo(n, point(5));
            default:
                return close();
        }
    }

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

    void moveTo(const Vec2& point) {
        finishSubpath(false);
        current_ = begin_ = point;
        forgetControls();
    }

    void lineTo(const Vec2& end) {
        append(lineToCubic(current_, end));
        forgetControls();
    }

    void arcTo(const Numbers& n, const Vec2& end) {
        for (const std::size_t i : {0, 1, 2}) checkSize(n[i]);
        const SvgArc arc{current_, {n[0], n[1]}, n[2], n[3] != 0, n[4] != 0, end};
        for (const CubicPiece& piece : arcToCubics(arc)) append(piece);
        forgetControls();
    }

    void close() {
        finishSubpath(true);
        current_ = begin_;
        forgetControls();
    }

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

    void cubicTo(const Vec2& control1, const Vec2& control2, const Vec2& end) {
        append({control1, control2, end});
        forgetControls();
        cubicControl_ = control2;
    }

    void quadraticTo(const Vec2& control, const Vec2& end) {
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

// The numbers of a command, with separators between them; nothing, and nothing taken, when they aren't all there.
std::optional<Numbers> takeNumbers(SvgScanner& scanner, const Command& command) {
    const std::size_t begin = scanner.place();
    Numbers numbers{};
    for (std::size_t i = 0; i < command.count; ++i) {
        if (i > 0) scanner.skipSeparator();
        const bool isFlag = command.letter == 'A' && (i == 3 || i == 4);
        const std::optional<Real> number = isFlag ? scanner.takeFlag() : scanner.takeNumber();
        if (!number) {
            scanner.goTo(begin);
            return std::nullopt;
        }
        numbers[i] = *number;
    }
    return numbers;
}

// A command with all the groups of numbers that follow it; those after a move are lines. False, and the scanner at the
// mistake, when it is malformed.
bool drawCommand(SvgScanner& scanner, SubpathBuilder& builder) {
    const std::size_t begin = scanner.place();
    std::optional<Command> command = commandOf(scanner.next());
    if (!command) return false;
    scanner.take(scanner.next());
    scanner.skipSpace();
    std::optional<Numbers> numbers = takeNumbers(scanner, *command);
    if (!numbers) {
        scanner.goTo(begin);
        return false;
    }
    builder.draw(*command, *numbers);
    if (command->letter == 'M') command->letter = 'L';
    for (std::size_t end = scanner.place(); command->count > 0; end = scanner.place()) {
        scanner.skipSeparator();
        numbers = takeNumbers(scanner, *command);
        if (!numbers) {
            scanner.goTo(end);
            break;
        }
        builder.draw(*command, *numbers);
    }
    scanner.skipSpace();
    return true;
}

}  // namespace

std::vector<BezierSpline> parseSvgPathData(std::string_view data, const SvgTransform& transform,
                                           const InputPlace& place) {
    SvgScanner scanner(data);
    SubpathBuilder builder(transform, place);
    const auto fail = [&](const std::string& reason) {
        throw InputError({place.file, place.line + lineOf(data, scanner.place()) - 1},
                         std::string(trimmed(scanner.rest())), reason);
    };
    scanner.skipSpace();
    const std::size_t first = scanner.place();
    if (!scanner.rest().empty() && scanner.next() != 'M' && scanner.next() != 'm')
        fail("path data must begin with M or m");
    while (!scanner.rest().empty()) {
        if (drawCommand(scanner, builder)) continue;
        fail(scanner.place() == first
                 ? "malformed path data: M needs two numbers"
                 : "malformed path data from here on; a command M L H V C S Q T A Z with its numbers is expected");
    }
    return builder.takeSplines();
}

}  // namespace caustic
