#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/process.h"
#include "core/progress.h"
#include "core/text.h"
#include "figure/gnuplot.h"
#include "figure/provenance.h"
#include "support/paths.h"

namespace caustic {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t anySize = std::size_t{1} << 24;

class Files : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            fs::path(testing::TempDir()) / ("caustic." + std::string(test->name()) + "." + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }
    std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            found.insert(entry.path().filename().string());
        return found;
    }

    fs::path folder_;
};

class AtomicFile : public Files {};

TEST_F(AtomicFile, MakesItsFolders) {
    writeTextAtomically(folder_ / "a/b/c.csv", "1,2\n");
    EXPECT_EQ(readTextFile(folder_ / "a/b/c.csv", anySize), "1,2\n");
    EXPECT_EQ(names(), (std::set<std::string>{"a", "b", "c.csv"}));
}

TEST_F(AtomicFile, KeepsTheOldFileAndLeavesNoTraceWhenWritingFails) {
    const auto path = write("figure.csv", "old");
    const auto failing = [](const fs::path& temporary) {
        std::ofstream(temporary) << "half a new fi";
        throw std::runtime_error("disk full");
    };
    EXPECT_THROW(writeAtomically(path, failing), std::runtime_error);
    EXPECT_EQ(readTextFile(path, anySize), "old");
    EXPECT_EQ(names(), std::set<std::string>{"figure.csv"});
}

// Image writers choose the format by the extension.
TEST_F(AtomicFile, TemporaryFileHasTheSameExtensionAndFolder) {
    writeAtomically(folder_ / "figure.png", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".png");
        EXPECT_EQ(temporary.parent_path(), folder_);
        EXPECT_NE(temporary.filename(), "figure.png");
        std::ofstream(temporary) << "x";
    });
    EXPECT_TRUE(fs::exists(folder_ / "figure.png"));
}

// A file where a folder should be stops even root, whom permissions do not.
TEST_F(AtomicFile, UnwritableFolderIsAnInputErrorWithItsName) {
    const auto blocker = write("blocker", "a file");
    try {
        writeTextAtomically(blocker / "sub/figure.csv", "x");
        FAIL() << "a file was written below a file";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(blocker.string()), std::string::npos) << error.what();
    }
    EXPECT_THROW(writeTextAtomically("/proc/figure.csv", "x"), InputError);
    EXPECT_EQ(names(), std::set<std::string>{"blocker"});
}

// A pipe stands for /dev/null, which root could really replace.
TEST_F(AtomicFile, DoesNotReplaceADevice) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(writeTextAtomically(pipe, "text"), InputError) << "Is what is there a file at all?";
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(names(), std::set<std::string>{"pipe"});
}

TEST_F(AtomicFile, DoesNotReplaceAFolder) {
    fs::create_directories(folder_ / "figure.csv/inside");
    EXPECT_THROW(writeTextAtomically(folder_ / "figure.csv", "x"), InputError);
    EXPECT_EQ(names(), (std::set<std::string>{"figure.csv", "inside"}));
}

class Processes : public Files {};

TEST_F(Processes, OutputAndExitCodeComeBack) {
    const auto result = runProcess({"sh", "-c", "echo out; echo err >&2; exit 3"});
    ASSERT_TRUE(result.has_value());
    EXPECT_EQ(result->output, "out\nerr\n");
    EXPECT_EQ(result->exitCode, 3);
}

TEST_F(Processes, SignalShowsAs128AndItsNumber) {
    EXPECT_EQ(runProcess({"sh", "-c", "kill -9 $$"})->exitCode, 128 + 9);
}

TEST_F(Processes, MissingProgramIsNothing) { EXPECT_FALSE(runProcess({"no-such-program-anywhere"}).has_value()); }

// Arguments are words, never a shell's text; standard input is empty, so that no program waits for a person.
TEST_F(Processes, ArgumentsPassUnchangedAndInputIsEmpty) {
    EXPECT_EQ(runProcess({"printf", "%s|", "a b", "$HOME", "'; rm *"})->output, "a b|$HOME|'; rm *|");
    EXPECT_EQ(runProcess({"cat"})->output, "");
}

// More than a pipe holds (64 KiB): reading must go on while the program writes.
TEST_F(Processes, LongOutputIsReadWhole) {
    EXPECT_EQ(runProcess({"sh", "-c", "head -c 1000000 /dev/zero | tr '\\0' x"})->output.size(), 1000000U);
}

class Gnuplot : public Files {
protected:
    // The message of the error that drawing this script ends in; empty when it is drawn.
    std::string failureOf(const std::string& script) const {
        try {
            drawChart({test::sourceDir() / "common/figure/style.gp", write("chart.gp", script)}, folder_,
                      folder_ / "chart.png");
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }
};

TEST_F(Gnuplot, DrawsAPngTheSameEachTime) {
    write("data.csv", "x,y\n1,2\n2,3\n");
    const std::string script = "plot folder.'/data.csv' using 'x':'y' with linespoints title 'Bézier'\n";
    ASSERT_EQ(failureOf(script), "");
    const std::string first = readTextFile(folder_ / "chart.png", anySize);
    EXPECT_EQ(first.substr(1, 3), "PNG");
    ASSERT_EQ(failureOf(script), "");
    EXPECT_TRUE(readTextFile(folder_ / "chart.png", anySize) == first) << "Does the picture hold a date?";
    EXPECT_EQ(names(), (std::set<std::string>{"chart.gp", "chart.png", "data.csv"}));
}

// Folders are the user's: a quote or a space in a name must not end gnuplot's string.
TEST_F(Gnuplot, FolderMayHaveQuotesAndSpaces) {
    folder_ /= "it's a folder";
    fs::create_directories(folder_);
    write("data.csv", "x,y\n1,2\n2,3\n");
    EXPECT_EQ(failureOf("plot folder.'/data.csv' using 1:2 with lines\n"), "");
    folder_ = folder_.parent_path();
}

TEST_F(Gnuplot, ItsComplaintIsTheReasonAndNothingIsWritten) {
    EXPECT_NE(failureOf("plot nonsense(\n").find("chart.gp"), std::string::npos);
    EXPECT_NE(failureOf("plot folder.'/missing.csv' using 1:2\n").find("missing.csv"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "chart.png"));
}

// gnuplot leaves with 0 after this one.
TEST_F(Gnuplot, ScriptThatDrawsNothingIsAFailure) { EXPECT_NE(failureOf("x = 1\n"), ""); }

TEST_F(Gnuplot, MissingProgramIsNamedWithItsPackage) {
    const char* const set = std::getenv("PATH");
    ASSERT_NE(set, nullptr);
    const std::string path = set;
    setenv("PATH", folder_.c_str(), 1);
    const std::string failure = failureOf("plot x\n");
    setenv("PATH", path.c_str(), 1);
    EXPECT_NE(failure.find("gnuplot-nox"), std::string::npos) << failure;
    EXPECT_FALSE(fs::exists(folder_ / "chart.png"));
}

class Provenance : public Files {
protected:
    void record(const std::string& figure, bool timed, std::uint64_t seed) {
        Progress progress(figure);
        ChapterOptions options;
        options.out = folder_;
        options.seed = seed;
        options.threads = 2;
        FigureContext context(inputs_, options, progress);
        context.output(figure + ".csv");
        context.output(figure + ".png");
        context.output(figure + ".csv");
        context.asset("assets/a.svg");
        recordProvenance(inputs_, options, {figure, {}, timed}, context, {1.23456, 70.7});
    }
    nlohmann::json read() const {
        return nlohmann::json::parse(readTextFile(folder_ / "01_test/provenance.json", anySize));
    }

    const ChapterInputs inputs_ = {"01_test", "/src", "abc", {{"assets/a.svg", "def"}}};
};

TEST_F(Provenance, SaysWhatAFigureWasMadeFrom) {
    record("chart", true, 5);
    const auto json = read();
    const auto& entry = json["figures"]["chart"];
    EXPECT_EQ(json["chapter"], "01_test");
    EXPECT_EQ(entry["files"], (nlohmann::json{"chart.csv", "chart.png"})) << "each file once";
    EXPECT_EQ(entry["inputs"]["sources"], "abc");
    EXPECT_EQ(entry["inputs"]["assets/a.svg"], "def");
    EXPECT_EQ(entry["seed"], 5);
    EXPECT_EQ(entry["threads"], 2);
    EXPECT_EQ(entry["quality"], "draft");
    EXPECT_EQ(entry["timed"], true);
    EXPECT_EQ(entry["peak_mib"], 71);
    EXPECT_NEAR(entry["seconds"].get<double>(), 1.23, 1e-12);
}

TEST_F(Provenance, OtherFiguresStay) {
    record("one", false, 1);
    record("two", false, 2);
    record("one", false, 3);
    const auto json = read();
    EXPECT_EQ(json["figures"].size(), 2U);
    EXPECT_EQ(json["figures"]["one"]["seed"], 3);
    EXPECT_EQ(json["figures"]["two"]["seed"], 2);
}

TEST_F(Provenance, BrokenFileIsNotReplacedInSilence) {
    fs::create_directories(folder_ / "01_test");
    for (const std::string text : {"", "{\"chapter\": ", "[1, 2]"}) {
        const auto path = write("01_test/provenance.json", text);
        EXPECT_THROW(record("one", false, 1), InputError);
        EXPECT_EQ(readTextFile(path, anySize), text);
    }
}

TEST_F(Provenance, UnknownAssetIsRefused) {
    Progress progress("x");
    const ChapterOptions options;
    FigureContext context(inputs_, options, progress);
    EXPECT_THROW(context.asset("assets/b.svg"), InputError);
    EXPECT_TRUE(context.assets().empty());
}

TEST_F(Provenance, CostIsMeasured) {
    const CostMeter meter;
    std::vector<char> block(std::size_t{64} << 20, 1);
    ASSERT_EQ(block[block.size() / 2], 1);
    const FigureCost cost = meter.cost();
    EXPECT_GT(cost.peakMiB, 64) << "64 MiB were held.";
    EXPECT_GT(cost.seconds, 0);
}

TEST(ProgressText, DurationsReadAsAPersonSaysThem) {
    EXPECT_EQ(formatDuration(0), "0.0 s");
    EXPECT_EQ(formatDuration(9.94), "9.9 s");
    EXPECT_EQ(formatDuration(9.96), "10 s");
    EXPECT_EQ(formatDuration(59.4), "59 s");
    EXPECT_EQ(formatDuration(59.6), "1 min 00 s");
    EXPECT_EQ(formatDuration(185), "3 min 05 s");
    EXPECT_EQ(formatDuration(3599.7), "1 h 00 min");
    EXPECT_EQ(formatDuration(7800), "2 h 10 min");
}

// In a log (no terminal) a figure is one line: no bar, no escape sequences.
TEST(ProgressText, IsPlainWhereThereIsNoTerminal) {
    testing::internal::CaptureStderr();
    {
        Progress progress("my_figure");
        progress.expect(3);
        for (int i = 0; i < 3; ++i) progress.advance();
    }
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_NE(text.find("my_figure"), std::string::npos);
}

}  // namespace
}  // namespace caustic
