#include "figure/chapter.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <thread>

#include <CLI/CLI.hpp>

#include "core/error.h"
#include "core/process.h"
#include "core/progress.h"
#include "figure/provenance.h"

namespace caustic {

namespace {

constexpr int exitFailure = 1;
constexpr int exitBadInput = 2;
constexpr int mostThreads = 1024;

struct CommandLine {
    ChapterOptions options;
    std::vector<std::string> only;
    bool list = false;
    const ChapterCommand* command = nullptr;
    std::string argument;
};

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

// Registers everything with CLI11 and parses; throws CLI::ParseError.
void parse(CLI::App& app, CommandLine& line, const std::vector<ChapterCommand>& commands, int argc,
           const char* const* argv) {
    line.options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    app.add_option("--out", line.options.out, "Folder to write to; a folder of the chapter's name is made in it")
        ->type_name("DIR")
        ->capture_default_str();
    const std::map<std::string, Quality> qualities = {{"draft", Quality::Draft}, {"report", Quality::Report}};
    app.add_option("--quality", line.options.quality, "draft (fast, the default) or report")
        ->transform(CLI::Transformer(qualities))
        ->type_name("Q");
    app.add_option("--threads", line.options.threads, "Threads; pictures don't depend on it")
        ->type_name("N")
        ->check(CLI::Range(1, mostThreads))
        ->capture_default_str();
    app.add_option("--seed", line.options.seed, "Seed of all random numbers")
        ->type_name("S")
        ->check(CLI::NonNegativeNumber)  // or -1 would wrap round to a huge number
        ->capture_default_str();
    app.add_option("--only", line.only, "Draw this figure only; may be given again")->type_name("FIGURE")->take_all();
    app.add_flag("--list", line.list, "List the figures and leave");
    app.add_flag("--preview", line.options.preview, "Show each picture in a window when it is ready; any key goes on");
    for (const ChapterCommand& command : commands) {
        app.add_option_function<std::string>(
               command.option,
               [&line, &command](const std::string& argument) {
                   line.command = &command;
                   line.argument = argument;
               },
               command.help)
            ->type_name(command.argument);
    }
    app.parse(argc, argv);
}

void run(const ChapterInputs& inputs, const CommandLine& line, const std::vector<Figure>& figures) {
    if (line.list) {
        for (const Figure& figure : figures) std::printf("%s%s\n", figure.name.c_str(), figure.timed ? " (timed)" : "");
        return;
    }
    if (line.command != nullptr) {
        line.command->run(line.argument, line.options);
        return;
    }
    for (const Figure& figure : chosenFigures(figures, line.only)) drawFigure(inputs, line.options, figure);
}

}  // namespace

int runChapter(const ChapterInputs& inputs, int argc, const char* const* argv, const std::vector<Figure>& figures,
               const std::vector<ChapterCommand>& commands) {
    CLI::App app{"Chapter " + inputs.name + ": draws its figures, charts and tables into <out>/" + inputs.name + "/.",
                 inputs.name};
    CommandLine line;
    try {
        parse(app, line, commands, argc, argv);
        run(inputs, line, figures);
        return 0;
    } catch (const CLI::Success& request) {
        return app.exit(request);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "%s: %s; see --help\n", inputs.name.c_str(), error.what());
        return exitBadInput;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s: %s\n", inputs.name.c_str(), error.what());
        return exitBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", inputs.name.c_str(), error.what());
        return exitFailure;
    }
}

}  // namespace caustic
