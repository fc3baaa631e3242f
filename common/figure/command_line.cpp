#include "figure/command_line.h"

#include <algorithm>
#include <limits>
#include <thread>

#include <CLI/CLI.hpp>

#include "core/error.h"
#include "core/text.h"
#include "figure/add_option.h"

namespace caustic {

namespace {

constexpr std::int64_t mostThreads = 1024;

// The options that every chapter has, and which of them are used by commands.
class Registered {
public:
    Registered(CLI::App& app, CommandLine& line, const std::vector<ChapterCommand>& commands)
        : app_(app), commands_(commands) {
        addCommon(line);
        for (const ChapterCommand& command : commands) {
            addOption(app, command.argument)->group("Instead of figures");
            for (const ChapterOption& option : command.options) {
                if (app.get_option_no_throw(option.name) == nullptr)
                    addOption(app, option)->capture_default_str()->group("With " + joined(ownersOf(option.name), ", "));
            }
        }
    }

    // The command that was given; null for none.
    const ChapterCommand* command() const {
        const ChapterCommand* found = nullptr;
        for (const ChapterCommand& command : commands_) {
            if (!given(command.argument.name)) continue;
            if (found != nullptr)
                throw InputError({command.argument.name, 0}, "",
                                 "can't be given together with " + found->argument.name);
            found = &command;
        }
        return found;
    }

    // Refuses what was given and isn't among the options that do something.
    void requireUsed(const std::vector<std::string>& used, const std::string& by) const {
        for (const CLI::Option* option : app_.get_options()) {
            const std::string name = option->get_name();
            if (option->count() == 0 || std::ranges::count(used, name) > 0) continue;
            const std::vector<std::string> owners = ownersOf(name);
            const std::string where = owners.empty() ? "" : "; it belongs to " + joined(owners, ", ");
            throw InputError({name, 0}, "", "does nothing " + by + where);
        }
    }

private:
    bool given(const std::string& name) const { return app_.get_option(name)->count() > 0; }

    // The commands that have an option of that name.
    std::vector<std::string> ownersOf(const std::string& name) const {
        std::vector<std::string> owners;
        for (const ChapterCommand& command : commands_) {
            for (const ChapterOption& option : command.options) {
                if (option.name == name) owners.push_back(command.argument.name);
            }
        }
        return owners;
    }

    void addCommon(CommandLine& line) {
        ChapterOptions& options = line.options;
        options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
        app_.add_option("--out", options.out, "Folder to write to; a folder of the chapter's name is made in it")
            ->type_name("DIR")
            ->capture_default_str();
        const ChoiceValue choice = {nullptr, {"draft", "report"}};
        const auto setQuality = [&options](const std::string& word) {
            options.quality = word == "report" ? Quality::Report : Quality::Draft;
        };
        app_.add_option_function<std::string>("--quality", setQuality, "How much work to do")
            ->check([choice](const std::string& text) { return complaint(choice, text); }, "", "")
            ->type_name("Q" + domainText(choice))
            ->default_str("draft");
        const RangedValue<std::int64_t> threads = {nullptr, 1, mostThreads};
        app_.add_option("--threads", options.threads, "Threads; pictures don't depend on it")
            ->check([threads](const std::string& text) { return complaint(threads, text); }, "", "")
            ->type_name("N" + domainText(threads))
            ->capture_default_str();
        const RangedValue<std::int64_t> seeds = {nullptr, 0, std::numeric_limits<std::int64_t>::max()};
        app_.add_option("--seed", options.seed, "Seed of all random numbers")
            ->check([seeds](const std::string& text) { return complaint(seeds, text); }, "", "")
            ->type_name("S" + domainText(seeds))
            ->capture_default_str();
        app_.add_option("--only", line.only, "Draw this figure only; may be given again")
            ->type_name("FIGURE")
            ->take_all();
        app_.add_flag("--list", line.list, "List the figures and leave");
        app_.add_flag("--preview", options.preview, "Show each picture in a window when it is ready; any key goes on");
    }

    CLI::App& app_;
    const std::vector<ChapterCommand>& commands_;
};

std::vector<std::string> usedBy(const ChapterCommand& command) {
    std::vector<std::string> used = command.uses;
    used.push_back(command.argument.name);
    for (const ChapterOption& option : command.options) used.push_back(option.name);
    return used;
}

}  // namespace

std::optional<CommandLine> readCommandLine(const std::string& chapter, const std::vector<ChapterCommand>& commands,
                                           int argc, const char* const* argv) {
    CLI::App app{"Chapter " + chapter + ": draws its figures, charts and tables into <out>/" + chapter + "/.", chapter};
    CommandLine line;
    const Registered registered(app, line, commands);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {
        app.exit(request);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw InputError({"", 0}, "", std::string(error.what()) + "; see --help");
    }
    line.command = registered.command();
    if (line.list) {
        registered.requireUsed({"--list"}, "with --list");
    } else if (line.command != nullptr) {
        registered.requireUsed(usedBy(*line.command), "with " + line.command->argument.name);
    } else {
        registered.requireUsed({"--out", "--quality", "--threads", "--seed", "--only", "--preview"}, "for figures");
    }
    return line;
}

}  // namespace caustic
