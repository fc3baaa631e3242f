#include "support/measured_process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace caustic::test {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Output goes to nameless files: unlike pipes, two of them can't fill up and block the program.
File namelessFile() {
    File file(std::tmpfile(), &std::fclose);
    if (!file) throw std::runtime_error("no temporary file can be made");
    return file;
}

std::string contents(std::FILE* file) {
    std::rewind(file);
    std::string text;
    std::array<char, 1 << 16> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file)) text.append(block.data(), count);
    return text;
}

// Starts the program and measures it. Not this test itself: what wait4 tells of a child includes what its parent held
// when it was forked, and a test may hold much. Arguments: report's descriptor, seconds, folder, program...
constexpr const char* launcher = R"(
import os, resource, sys
report, seconds, folder, *command = sys.argv[1:]
child = os.fork()
if child == 0:
    try:
        os.close(int(report))
        os.chdir(folder)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))
        os.execvp(command[0], command)
    finally:
        os._exit(127)
_, status, usage = os.wait4(child, 0)
code = os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128 + os.WTERMSIG(status)
os.write(int(report), f'{code} {usage.ru_maxrss}'.encode())
)";

[[noreturn]] void become(std::vector<std::string> words, int out, int err) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0) execvp(arguments.front(), arguments.data());
    _exit(127);
}

}  // namespace

MeasuredRun runMeasured(const std::vector<std::string>& command, const std::filesystem::path& folder,
                        unsigned mostSeconds) {
    const File out = namelessFile();
    const File err = namelessFile();
    const File report = namelessFile();
    std::vector<std::string> words = {
        "python3", "-c", launcher, std::to_string(fileno(report.get())), std::to_string(mostSeconds), folder.string()};
    words.insert(words.end(), command.begin(), command.end());

    const pid_t child = fork();
    if (child == 0) become(std::move(words), fileno(out.get()), fileno(err.get()));
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) throw std::runtime_error("no process can be started");

    MeasuredRun run{0, contents(out.get()), contents(err.get()), 0};
    long kibibytes = 0;
    std::istringstream answer(contents(report.get()));
    if (!(answer >> run.exitCode >> kibibytes)) throw std::runtime_error("the launcher failed: " + run.errors);
    run.peakMiB = static_cast<double>(kibibytes) / 1024;
    return run;
}

}  // namespace caustic::test
