#include "figure/gnuplot.h"

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/process.h"

namespace caustic {

std::string gnuplotString(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';  // between single quotes, a quote is written twice
        quoted += c;
    }
    return quoted + "'";
}

void drawChart(const std::vector<std::filesystem::path>& scripts, const std::filesystem::path& folder,
               const std::filesystem::path& png, const std::string& settings) {
    writeAtomically(png, [&](const std::filesystem::path& temporary) {
        std::vector<std::string> command = {
            "gnuplot", "-e",
            "folder=" + gnuplotString(folder) + "; output=" + gnuplotString(temporary) + "; " + settings};
        for (const auto& script : scripts) command.push_back(script.string());
        const auto result = runProcess(command);
        if (!result)
            throw InputError({"gnuplot", 0}, "", "is not installed: it draws the charts (package gnuplot-nox)");
        // gnuplot leaves with 0 after some errors, a file without points for one; it then says so and writes nothing.
        const bool written = std::filesystem::exists(temporary) && std::filesystem::file_size(temporary) > 0;
        if (result->exitCode != 0 || !written)
            throw InputError({scripts.back().string(), 0}, "", "gnuplot failed: " + result->output);
    });
}

}  // namespace caustic
