#include "mesh/obj_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/not_implemented.h"
#include "core/text.h"
#include "mesh/polygon.h"

namespace caustic {

namespace {

constexpr std::size_t mostBytes = std::size_t{1} << 30;
constexpr std::size_t mostNumbers = 0xfffffffe;

// What a corner of a face may name, in the order of "v/vt/vn".
enum Part : std::size_t { Position, Uv, Normal };
constexpr std::array<const char*, 3> partNames = {"vertex", "texture coordinate", "normal"};

using Corner = std::array<std::uint32_t, 3>;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    MeshData read() {
        if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))
            fail("", "is UTF-16; must be UTF-8 or ASCII");
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
        while (nextLine()) readStatement();
        checkForwardReferences();
        if (mesh_.triangles.empty()) throw InputError({file_, 0}, "", "has no face");
        if (!anyUv_) mesh_.uvCorners.clear();
        if (!anyNormal_) mesh_.normalCorners.clear();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(std::string_view value, const std::string& reason) const {
        throw InputError({file_, line_}, std::string(value), reason);
    }

    // Takes the next line, without its comment. A backslash at the end of a statement that is read joins the line that
    // follows; at the end of a comment or a name, as in "# D:\\out\\", it is a part of that.
    bool nextLine() {
        line_ = nextLineNumber_;
        if (place_ >= text_.size()) return false;
        rest_ = takeLine();
        if (!goesOn(rest_) || !isRead(rest_)) return true;
        joined_.clear();
        while (goesOn(rest_)) {
            joined_ += rest_.substr(0, rest_.rfind('\\'));
            joined_ += ' ';
            rest_ = place_ < text_.size() ? takeLine() : std::string_view();
        }
        joined_ += rest_;
        rest_ = joined_;
        return true;
    }

    static bool goesOn(std::string_view line) { return !line.empty() && line.back() == '\\'; }

    static bool isRead(std::string_view line) {
        const std::string_view keyword = takeWord(line);
        return keyword == "v" || keyword == "vn" || keyword == "vt" || keyword == "f";
    }

    // Up to its end or its comment, without blanks at the end.
    std::string_view takeLine() {
        const std::size_t end = std::min(text_.find('\n', place_), text_.size());
        std::string_view line = text_.substr(place_, end - place_);
        place_ = end + 1;
        ++nextLineNumber_;
        line = withoutBlanksAtEnd(line);
        if (line.find('\r') != std::string_view::npos) {
            line_ = nextLineNumber_ - 1;
            fail("", "has a lone CR, as old Macs ended lines; must be LF or CR LF");
        }
        return withoutBlanksAtEnd(line.substr(0, line.find('#')));
    }

    static std::string_view withoutBlanksAtEnd(std::string_view line) {
        while (!line.empty() && isSpace(line.back())) line.remove_suffix(1);
        return line;
    }

    // The next word of the line; empty when there is none.
    std::string_view word() { return takeWord(rest_); }

    static std::string_view takeWord(std::string_view& line) {
        std::size_t begin = 0;
        while (begin < line.size() && isSpace(line[begin])) ++begin;
        std::size_t end = begin;
        while (end < line.size() && !isSpace(line[end])) ++end;
        const std::string_view found = line.substr(begin, end - begin);
        line.remove_prefix(end);
        return found;
    }

    void readStatement() {
        const std::string_view keyword = word();
        if (keyword == "v") {
            mesh_.positions.push_back(readVec3("three coordinates"));
            checkRest();
        } else if (keyword == "vn") {
            mesh_.normals.push_back(readVec3("three components"));
        } else if (keyword == "vt") {
            readUv();
        } else if (keyword == "f") {
            readFace();
        }
    }

    Real readNumber(std::string_view text, const char* what) const {
        if (text.empty()) fail("", std::string("needs ") + what);
        const std::optional<double> value = parseReal(text);
        if (!value || !std::isfinite(*value)) fail(text, "must be a finite number");
        return *value;
    }

    Vec3 readVec3(const char* what) {
        Vec3 value;
        for (Real& component : value) component = readNumber(word(), what);
        return value;
    }

    // A weight, a colour: numbers, whatever they mean.
    void checkRest() {
        for (std::string_view text = word(); !text.empty(); text = word()) readNumber(text, "numbers");
    }

    void readUv() {
        Vec2 uv = Vec2::Zero();
        uv.x() = readNumber(word(), "one to three coordinates");
        const std::string_view second = word();
        if (!second.empty()) uv.y() = readNumber(second, "numbers");
        checkRest();
        mesh_.uvs.push_back(uv);
    }

    void readFace() {
        face_.clear();
        for (std::string_view text = word(); !text.empty(); text = word()) face_.push_back(readCorner(text));
        if (face_.size() < 3) fail(std::to_string(face_.size()) + " corners", "a face needs at least three");
        if (mesh_.triangles.size() + face_.size() > mostNumbers) fail("", "has more faces than can be counted");
        if (face_.size() == 3) {
            addTriangle({0, 1, 2});
        } else {
            addPolygon();
        }
    }

    // "v", "v/vt", "v//vn" or "v/vt/vn".
    Corner readCorner(std::string_view text) {
        const std::string_view whole = text;
        Corner corner = {MeshData::none, MeshData::none, MeshData::none};
        for (std::size_t part = Position; part <= Normal; ++part) {
            const std::size_t slash = std::min(text.find('/'), text.size());
            const std::string_view number = text.substr(0, slash);
            if (!number.empty()) {
                corner[part] = readIndex(number, Part{part});
            } else if (part == Position) {
                fail(whole, "a corner must name a vertex");
            }
            if (slash == text.size()) return corner;
            text.remove_prefix(slash + 1);
        }
        fail(whole, "a corner names at most a vertex, a texture coordinate and a normal");
    }

    std::size_t soFar(Part part) const {
        if (part == Position) return mesh_.positions.size();
        return part == Uv ? mesh_.uvs.size() : mesh_.normals.size();
    }

    std::uint32_t readIndex(std::string_view text, Part part) {
        const std::optional<long long> number = parseInteger(text);
        if (!number) fail(text, std::string("must be the number of a ") + partNames[part]);
        const std::optional<std::uint32_t> index = objIndex(*number, soFar(part));
        if (!index) {
            fail(text, std::string("names no ") + partNames[part] + "; " + std::to_string(soFar(part)) +
                           " have been read, and numbers start at 1");
        }
        if (*index >= soFar(part) && (!latest_[part].line || *index > latest_[part].index)) {
            latest_[part] = {*index, line_};
        }
        return *index;
    }

    // Faces may come before their vertices. The highest number of each kind has to be there in the end.
    void checkForwardReferences() {
        for (const Part part : {Position, Uv, Normal}) {
            if (latest_[part].line == 0 || latest_[part].index < soFar(part)) continue;
            line_ = latest_[part].line;
            fail(std::to_string(std::size_t{latest_[part].index} + 1),
                 std::string("names no ") + partNames[part] + "; the file has " + std::to_string(soFar(part)));
        }
        for (const PendingPolygon& pending : pending_) cutPending(pending);
    }

    void addTriangle(const MeshData::Corners& corners) { addTriangle(face_, corners); }

    void addTriangle(const std::vector<Corner>& face, const MeshData::Corners& corners) {
        MeshData::Corners positions;
        MeshData::Corners uvs;
        MeshData::Corners normals;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner& corner = face[corners[i]];
            positions[i] = corner[Position];
            uvs[i] = corner[Uv];
            normals[i] = corner[Normal];
            anyUv_ = anyUv_ || corner[Uv] != MeshData::none;
            anyNormal_ = anyNormal_ || corner[Normal] != MeshData::none;
        }
        mesh_.triangles.push_back(positions);
        mesh_.uvCorners.push_back(uvs);
        mesh_.normalCorners.push_back(normals);
    }

    struct PendingPolygon {
        std::vector<Corner> face;
        std::size_t line;
    };

    void addPolygon() {
        const bool known =
            std::ranges::all_of(face_, [&](const Corner& corner) { return corner[Position] < mesh_.positions.size(); });
        if (known) {
            cut(face_);
        } else {
            pending_.push_back({face_, line_});
        }
    }

    void cutPending(const PendingPolygon& pending) {
        line_ = pending.line;
        cut(pending.face);
    }

    void cut(const std::vector<Corner>& face) {
        std::vector<Vec3> corners;
        corners.reserve(face.size());
        for (const Corner& corner : face) corners.push_back(mesh_.positions[corner[Position]]);
        if (corners.size() > mostConcaveCorners && !isConvex(corners)) {
            fail(std::to_string(corners.size()) + " corners",
                 "a concave face may have at most " + std::to_string(mostConcaveCorners));
        }
        for (const auto& triangle : triangulated(corners)) addTriangle(face, triangle);
    }

    struct Latest {
        std::uint32_t index = 0;
        std::size_t line = 0;  // 0: no forward reference
    };

    std::string_view text_;
    const std::string& file_;
    std::size_t place_ = 0;
    std::size_t line_ = 1;
    std::size_t nextLineNumber_ = 1;
    std::string joined_;
    std::string_view rest_;
    std::vector<Corner> face_;
    std::vector<PendingPolygon> pending_;
    std::array<Latest, 3> latest_;
    bool anyUv_ = false;
    bool anyNormal_ = false;
    MeshData mesh_;
};

}  // namespace

std::optional<std::uint32_t> objIndex(long long number, std::size_t soFar) {
    //! [ex-04.8]
    const auto count = static_cast<long long>(soFar);
    if (number == 0 || number < -count || number > static_cast<long long>(mostNumbers)) return std::nullopt;
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : count + number);
    //! [ex-04.8]
}

MeshData parseObj(std::string_view text, const std::string& file) { return ObjReader(text, file).read(); }

MeshData loadObj(const std::filesystem::path& path) { return parseObj(readTextFile(path, mostBytes), path.string()); }

}  // namespace caustic
