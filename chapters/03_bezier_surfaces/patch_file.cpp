#include "patch_file.h"

#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

constexpr std::size_t mostBytes = std::size_t{4} << 20;
constexpr long long highestDegree = 9;

class PatchReader {
public:
    PatchReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::vector<NamedPatch> run() {
        std::vector<NamedPatch> patches;
        while (nextLine()) patches.push_back(readPatch());
        if (patches.empty()) fail("", "has no patch");
        return patches;
    }

private:
    [[noreturn]] void fail(const std::string& value, const std::string& reason) const {
        throw InputError({file_, line_}, value, reason);
    }

    // The words of the next line that has any; false at the end.
    bool nextLine() {
        while (!text_.empty()) {
            ++line_;
            const std::size_t end = text_.find('\n');
            std::string_view line = text_.substr(0, end);
            text_ = end == std::string_view::npos ? std::string_view() : text_.substr(end + 1);
            line = line.substr(0, line.find('#'));
            words_.clear();
            while (!(line = trimmed(line)).empty()) {
                const std::size_t length = std::min(line.find_first_of(" \t"), line.size());
                words_.emplace_back(line.substr(0, length));
                line = line.substr(length);
            }
            if (!words_.empty()) return true;
        }
        return false;
    }

    int readDegree(const std::string& word) const {
        const auto degree = parseInteger(word);
        if (!degree || *degree < 1 || *degree > highestDegree) fail(word, "a patch's degree must be 1 to 9");
        return static_cast<int>(*degree);
    }

    NamedPatch readPatch() {
        if (words_[0] != "patch" || words_.size() != 4) fail(words_[0], "expected 'patch', a name and two degrees");
        const std::string name = words_[1];
        const int m = readDegree(words_[2]);
        const int n = readDegree(words_[3]);
        std::vector<Vec3> points;
        for (int i = 0; i <= m; ++i) {
            if (!nextLine()) fail("", "the file ends within patch '" + name + "'");
            readRow(n, points);
        }
        return {name, BezierPatch(m, n, std::move(points))};
    }

    void readRow(int n, std::vector<Vec3>& points) const {
        const auto expected = static_cast<std::size_t>(3 * (n + 1));
        if (words_.size() != expected) {
            fail(std::to_string(words_.size()) + " numbers", "a row of this patch has " + std::to_string(expected));
        }
        for (std::size_t i = 0; i < expected; i += 3) {
            points.emplace_back(readNumber(words_[i]), readNumber(words_[i + 1]), readNumber(words_[i + 2]));
        }
    }

    Real readNumber(const std::string& word) const {
        const auto number = parseReal(word);
        if (!number || !std::isfinite(*number)) fail(word, "must be a finite number");
        return *number;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t line_ = 0;
    std::vector<std::string> words_;
};

}  // namespace

std::vector<NamedPatch> parsePatches(std::string_view text, const std::string& file) {
    return PatchReader(text, file).run();
}

std::vector<NamedPatch> loadPatches(const std::filesystem::path& path) {
    return parsePatches(readTextFile(path, mostBytes), path.string());
}

}  // namespace caustic
