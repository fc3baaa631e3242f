#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace caustic {

class Progress;

/// How much work a figure may take: a draft to look at (all figures within minutes), or what goes into the report.
enum class Quality { Draft, Report };

/// What an executable was built from; generated as `thisChapter` in chapter_inputs.h.
struct ChapterInputs {
    std::string name;                           ///< "01_bezier_curves"
    std::filesystem::path sourceDir;            ///< top of the repository
    std::string sourcesHash;                    ///< SHA-256 over the sources that the chapter is made of
    std::map<std::string, std::string> assets;  ///< path below sourceDir -> SHA-256
};

/// What the user asked for.
struct ChapterOptions {
    std::filesystem::path out = "figures";  ///< figures go to `out/chapter/`
    Quality quality = Quality::Draft;       ///< how much work to do
    int threads = 1;                        ///< at least 1
    std::uint64_t seed = 1;                 ///< the same seed gives the same figures, whatever the threads
    bool preview = false;                   ///< whether to show figures in a window as they grow
};

/// What the function that draws a figure gets: where to write, how much work to do, and a record of both.
class FigureContext {
public:
    /// All three are kept by reference and have to live as long.
    FigureContext(const ChapterInputs& inputs, const ChapterOptions& options, Progress& progress)
        : inputs_(&inputs), options_(&options), progress_(&progress) {}

    /// Where to write the output file of this name; remembers it for provenance.json.
    std::filesystem::path output(const std::string& file);

    /// Where to read an asset, named by its path below the repository ("assets/profiles/wine_glass.svg"); remembers it
    /// as an input of the figure.
    /// @throws InputError when there is no such asset
    std::filesystem::path asset(const std::string& path);

    /// Draws a chart: runs gnuplot on the common style and then on the script of that name in the chapter's folder. The
    /// script finds the folder of the CSV files in the variable `folder`.
    void chart(const std::string& script, const std::string& png);

    /// The same with a script of this topic's folder, for charts that chapters share.
    /// @param settings  gnuplot commands that come first
    void sharedChart(const std::string& script, const std::string& png, const std::string& settings = "");

    /// How much work to do.
    Quality quality() const { return options_->quality; }
    /// One of two values, by quality.
    template <typename Value>
    Value byQuality(Value draft, Value report) const {
        return quality() == Quality::Draft ? draft : report;
    }
    /// How many threads to use, at least 1.
    int threads() const { return options_->threads; }
    /// The seed for the figure's random numbers.
    std::uint64_t seed() const { return options_->seed; }
    /// Where to report how far the figure is.
    Progress& progress() { return *progress_; }

    /// File names that output() was asked for.
    const std::vector<std::string>& outputs() const { return outputs_; }
    /// Paths that asset() was asked for.
    const std::vector<std::string>& assets() const { return assets_; }

private:
    void draw(const std::filesystem::path& script, const std::string& png, const std::string& settings);

    const ChapterInputs* inputs_;
    const ChapterOptions* options_;
    Progress* progress_;
    std::vector<std::string> outputs_;
    std::vector<std::string> assets_;
};

/// A row of a chapter's table of contents.
struct Figure {
    std::string name;                          ///< as `--only` takes it
    std::function<void(FigureContext&)> draw;  ///< draws it and writes its files
    bool timed = false;                        ///< whether it shows measured times, and so differs from run to run
};

}  // namespace caustic
