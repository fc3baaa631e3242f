#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "curve/profile_text.h"
#include "support/measured_process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// The real program, run as a user would in an empty folder.
class Inspect : public testing::Test {
protected:
#ifdef __SANITIZE_ADDRESS__
    static constexpr double mostMiB = 300;  // the sanitizer's zones around each block and its map of them come on top
#elif defined(__SANITIZE_THREAD__)
    static constexpr double mostMiB = 1000;  // four bytes to know the last uses of each
#else
    static constexpr double mostMiB = 200;
#endif

    test::MeasuredRun inspect(const std::string& profile) const {
        fs::create_directories(folder_.path() / "empty");
        // The sanitizer keeps freed memory for a while to catch uses of it; that is not the program's.
        return test::runMeasured({"env", "ASAN_OPTIONS=quarantine_size_mb=1:thread_local_quarantine_size_kb=64",
                                  test::chapterProgram(), "--inspect", profile},
                                 folder_.path() / "empty");
    }

    Json inspected(const std::string& profile) const {
        const test::MeasuredRun run = inspect(profile);
        EXPECT_EQ(run.exitCode, 0) << run.errors;
        EXPECT_EQ(run.errors, "");
        return Json::parse(run.output);
    }

    // Exit code 2, one line on standard error that names the file and holds the reason, nothing else written.
    void expectRefused(const std::string& profile, const std::string& reason) const {
        const test::MeasuredRun run = inspect(profile);
        EXPECT_EQ(run.exitCode, 2) << profile << ": " << run.errors;
        EXPECT_EQ(run.output, "") << profile;
        EXPECT_NE(run.errors.find(reason), std::string::npos) << profile << ": " << run.errors;
        EXPECT_NE(run.errors.find(profile.substr(0, profile.find('#'))), std::string::npos) << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_TRUE(fs::is_empty(folder_.path() / "empty")) << profile << ": something was written";
        EXPECT_LT(run.peakMiB, mostMiB) << profile;
    }

    // An SVG file with a path of this data.
    std::string path(const std::string& data) const {
        return folder_.write("path.svg", "<svg><path id='p' d='" + data + "'/></svg>");
    }

    test::TemporaryFolder folder_;
};

TEST_F(Inspect, PrintsSegmentsJointsLengthAndBox) {
    const Json json = inspected(path("M0 0 L3 0 L3 4z"));
    const Json& drawn = json["paths"][0];
    EXPECT_EQ(drawn["id"], "p");
    EXPECT_EQ(drawn["line"], 1);
    EXPECT_EQ(drawn["drawn"], true);
    EXPECT_EQ(drawn["transform"], Json({1, 0, 0, 1, 0, 0}));
    EXPECT_NEAR(drawn["length"].get<double>(), 12, drawn["lengthError"].get<double>());
    EXPECT_LT(drawn["lengthError"].get<double>(), 1e-11);
    const Json& subpath = drawn["subpaths"][0];
    EXPECT_EQ(subpath["closed"], true);
    EXPECT_EQ(subpath["segments"].size(), 3U);
    EXPECT_EQ(subpath["segments"][0][3], Json({3, 0}));
    EXPECT_EQ(subpath["joints"].size(), 3U);
    EXPECT_EQ(subpath["joints"][0]["continuity"], "C0");
    EXPECT_NEAR(subpath["joints"][0]["angle"].get<double>(), std::acos(0.0), 1e-14);
    EXPECT_NEAR(subpath["bounds"]["max"][1].get<double>(), 4, 1e-12);
    EXPECT_GE(subpath["bounds"]["max"][1].get<double>(), 4);
    EXPECT_LE(subpath["bounds"]["min"][0].get<double>(), 0);
}

TEST_F(Inspect, ShowsEveryDrawnPathOrTheChosenOne) {
    const std::string file = folder_.write(
        "three.svg", "<svg><path id='a' d='M0 0L1 1M2 2L3 3'/><defs><path id='b' d='M0 0L0 2'/></defs><path/></svg>");
    const Json all = inspected(file);
    ASSERT_EQ(all["paths"].size(), 2U);
    EXPECT_EQ(all["paths"][0]["subpaths"].size(), 2U);
    EXPECT_EQ(all["paths"][1]["id"], nullptr);
    EXPECT_EQ(all["paths"][1]["length"], 0);
    EXPECT_EQ(all["paths"][1]["bounds"], nullptr);
    EXPECT_EQ(inspected(file + "#b")["paths"][0]["drawn"], false);
    EXPECT_EQ(inspected(file + "#2")["paths"][0]["line"], 1);
}

TEST_F(Inspect, ReadsControlPoints) {
    const Json flat = inspected(folder_.write("flat.txt", "0 0\n1 0\n2 0\n3 0\n"));
    EXPECT_EQ(flat["kind"], "control points");
    EXPECT_EQ(flat["paths"][0]["subpaths"][0]["segments"][0], Json({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
    const Json spatial = inspected(folder_.write("spatial.txt", "0 0 0\n1 0 0\n2 0 0\n3 0 4\n"));
    EXPECT_EQ(spatial["paths"][0]["subpaths"][0]["segments"][0][3], Json({3, 0, 4}));
}

TEST_F(Inspect, AnIdThatIsNoUtf8StillMakesJson) {
    const std::string file = folder_.write("latin1.svg", "<svg><path id='ros\xE9' d='M0 0L1 1'/></svg>");
    EXPECT_EQ(inspected(file)["paths"][0]["id"], "ros\xEF\xBF\xBD");
}

// A line for each segment and joint, and neither time nor memory that grows faster. (A million are read by
// LongPaths.OfAMillionSegmentsAreRead.)
TEST_F(Inspect, AHundredThousandSegmentsArePrintedInLittleMemory) {
    std::string data = "M0 0";
    for (int i = 0; i < 50000; ++i) data += "h1v1";
    const test::MeasuredRun run = inspect(path(data));
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_LT(run.peakMiB, mostMiB);
    const Json subpath = Json::parse(run.output)["paths"][0]["subpaths"][0];
    EXPECT_EQ(subpath["segments"].size(), 100000U);
    EXPECT_EQ(subpath["joints"].size(), 99999U);
    EXPECT_NEAR(subpath["length"].get<double>(), 100000, subpath["lengthError"].get<double>());
}

TEST_F(Inspect, RefusesWhatIsNoProfile) {
    expectRefused(folder_.write("empty.svg", ""), "is empty");
    expectRefused(folder_.write("empty.txt", ""), "is empty");
    expectRefused(folder_.write("none.svg", "<svg><rect/></svg>"), "draws no path; it draws 1 rect");
    expectRefused(folder_.write("wide.svg", std::string("\xFF\xFE<\0s\0v\0g\0", 10)), "UTF-16");
    expectRefused(folder_.write("cut.svg", "<svg><path d='M0 0"), "is no well-formed XML");
    expectRefused(folder_.write("html.svg", "<!DOCTYPE html><html></html>"), "its root is not svg");
    expectRefused(folder_.write("three.txt", "0 0\n1 1\n2 2\n"), "3n + 1 control points");
    expectRefused(folder_.write("binary.txt", std::string("\x7f"
                                                          "ELF\x02\x01\x01\0\0\0",
                                                          10)),
                  "zero byte");
}

TEST_F(Inspect, RefusesBadPathData) {
    expectRefused(path("M0 0 L1 1 L2 oops"), ":1: malformed path data from here on");
    expectRefused(path("M0 0 L nan 1"), "L nan 1");
    expectRefused(path("M0 0 L 1e400 1"), "L 1e400 1");
    expectRefused(path("M0 0 L 1e200 1"), "larger than 1e+100");
    expectRefused(folder_.write("nan.txt", "0 0\n1 nan\n2 2\n3 3\n"), ":2: must be a finite number (got 'nan')");
    expectRefused(folder_.write("huge.txt", "0 0\n1 1e400\n2 2\n3 3\n"), ":2: must be a number that a double can hold");
}

TEST_F(Inspect, RefusesUnknownChoices) {
    expectRefused(path("M0 0L1 1") + "#rim", "has no such path; choose one of #p (got 'rim')");
    expectRefused(path("M0 0L1 1") + "#2", "has no such path");
    expectRefused(folder_.write("points.txt", "0 0\n1 1\n2 2\n3 3\n").string() + "#1", "nothing to choose");
}

// Root may read what has mode 000, so these are paths that nobody can read.
TEST_F(Inspect, RefusesPathsThatCantBeRead) {
    expectRefused((folder_.path() / "missing.svg").string(), "no such file");
    expectRefused(folder_.path().string(), "is a folder");
    expectRefused(folder_.write("file.txt", "0 0\n").string() + "/below", "no such file");
    expectRefused(std::string(5000, 'x'), "");
    expectRefused("/proc/self/mem", "cannot be read");

    const std::string socketPath = (folder_.path() / "s").string();
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(socketPath.size(), sizeof(address.sun_path)) << "TMPDIR is too long for a socket";
    std::copy(socketPath.begin(), socketPath.end(), address.sun_path);
    const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    expectRefused(socketPath, "cannot be opened");
    close(listener);
}

TEST_F(Inspect, RefusesHugeFilesInLittleMemory) {
    constexpr std::uintmax_t hundredMegabytes = 100'000'000;
    const fs::path zeros = folder_.write("zeros.svg", "<svg>");
    fs::resize_file(zeros, hundredMegabytes);
    expectRefused(zeros, "is larger than 16 MiB");
    expectRefused("/dev/zero", "is larger than 16 MiB");

    std::string points;
    while (points.size() < (std::size_t{15} << 20)) points += "1 1\n";
    expectRefused(folder_.write("points.txt", points), "more than a million segments");

    std::string lines = "M0 0h";
    while (lines.size() < (std::size_t{15} << 20)) lines += "1 ";
    expectRefused(path(lines), "more than a million segments");

    std::string tags = "<svg>";
    while (tags.size() < (std::size_t{15} << 20)) tags += "<g/>";
    expectRefused(folder_.write("tags.svg", tags + "</svg>"), "more markup than a drawing needs");
}

// As much markup as is let through: what the limit promises must hold for the whole program.
TEST_F(Inspect, HoldsTheMostMarkupThatIsAllowedInLittleMemory) {
    std::string nested = "<svg>";
    for (int i = 0; i < 390000; ++i) nested += "<g>";
    expectRefused(folder_.write("nested.svg", nested), "is no well-formed XML");
    for (int i = 0; i < 390000; ++i) nested += "</g>";
    expectRefused(folder_.write("nested.svg", nested + "</svg>"), "draws no path");
    std::string texts = "<svg>";
    for (int i = 0; i < 800000; ++i) texts += "<g/>t";
    expectRefused(folder_.write("texts.svg", texts + "</svg>"), "draws no path");
    std::string attributes = "<svg ";
    for (int i = 0; i < 2600000; ++i) attributes += "a='' ";
    expectRefused(folder_.write("attributes.svg", attributes + "/>"), "draws no path");
}

TEST_F(Inspect, RefusesXmlBombsInLittleMemory) {
    std::string bomb = "<!DOCTYPE svg [\n<!ENTITY a0 'M0 0 '>\n";
    for (int i = 1; i < 30; ++i) {
        const std::string entity = "&a" + std::to_string(i - 1) + ";";
        bomb += "<!ENTITY a" + std::to_string(i) + " '" + entity + entity + entity + entity + "'>\n";
    }
    expectRefused(folder_.write("bomb.svg", bomb + "]><svg><path d='&a29;'/></svg>"), "declares entities");
}

TEST_F(Inspect, SaysWhenItsOutputIsLost) {
    const std::string file = path("M0 0L1 1");
    const test::MeasuredRun run = test::runMeasured(
        {"sh", "-c", "exec \"$0\" --inspect \"$1\" > /dev/full", test::chapterProgram(), file}, folder_.path());
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_NE(run.errors.find("standard output: cannot be written"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace caustic
