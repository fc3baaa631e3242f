#include "figure/chapter.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "core/error.h"
#include "core/process.h"
#include "core/progress.h"
#include "figure/command_line.h"
#include "figure/provenance.h"

namespace caustic {

namespace {

constexpr int exitFailure = 1;
constexpr int exitBadInput = 2;

const Figure& findFigure(const std::vector<Figure>& figures, const std::string& name) {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == name; });
    if (found != figures.end()) return *found;
    std::string names;
    for (const Figure& figure : figures) names += (names.empty() ? "" : ", ") + figure.name;
    throw InputError({"--only", 0}, name, "no such figure; this chapter has " + names);
}

std::vector<Figure> chosenFigures(const std::vector<Figure>& figures, const std::vector<std::string>& only) {
    if (only.empty()) return figures;
    std::vector<Figure> chosen;
    for (const std::string& name : only) chosen.push_back(findFigure(figures, name));
    return chosen;
}

// The viewer is a program of its own: linking OpenCV's windows would load Qt into every run of every chapter.
void preview(const std::filesystem::path& file) {
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    const auto result = runProcess({(self.parent_path() / "preview").string(), file.string()});
    if (!result || result->exitCode != 0) throw InputError({"--preview", 0}, "", "no window can be opened here");
}

void drawFigure(const ChapterInputs& inputs, const ChapterOptions& options, const Figure& figure) {
    const CostMeter meter;
    Progress progress(figure.name);
    FigureContext context(inputs, options, progress);
    figure.draw(context);
    recordProvenance(inputs, options, figure, context, meter.cost());
    if (!options.preview) return;
    for (const std::string& file : context.outputs()) {
        if (file.ends_with(".png")) preview(options.out / inputs.name / file);
    }
}

void run(const ChapterInputs& inputs, const CommandLine& line, const std::vector<Figure>& figures) {
    if (line.list) {
        for (const Figure& figure : figures) std::printf("%s%s\n", figure.name.c_str(), figure.timed ? " (timed)" : "");
        return;
    }
    if (line.command != nullptr) {
        line.command->run(line.options);
        return;
    }
    for (const Figure& figure : chosenFigures(figures, line.only)) drawFigure(inputs, line.options, figure);
}

}  // namespace

int runChapter(const ChapterInputs& inputs, int argc, const char* const* argv, const std::vector<Figure>& figures,
               const std::vector<ChapterCommand>& commands) {
    try {
        const auto line = readCommandLine(inputs.name, commands, argc, argv);
        if (line) run(inputs, *line, figures);
        return 0;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s: %s\n", inputs.name.c_str(), error.what());
        return exitBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", inputs.name.c_str(), error.what());
        return exitFailure;
    }
}

}  // namespace caustic
