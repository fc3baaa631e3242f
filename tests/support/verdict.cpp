#include "support/verdict.h"

#include <cxxabi.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "core/not_implemented.h"

namespace caustic::test {

namespace {

constexpr std::string_view option = "--verdict=";
constexpr std::string_view question = "over\n";
constexpr std::size_t longestWord = 256;
constexpr std::size_t longestMessage = 2000;
constexpr std::size_t mostFailures = 10;

struct Failure {
    std::string place;  ///< "graded_bezier_curve.cpp:14"; empty for an exception
    std::string message;
    std::size_t times = 1;  ///< an assertion in a loop fails at one place many times; the first message is kept
};

/// Keeps the first failure of each place, and how many there were.
class FailureCollector : public testing::EmptyTestEventListener {
public:
    explicit FailureCollector(std::vector<Failure>& failures) : failures_(&failures) {}

    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (!result.failed()) return;
        std::string place;
        if (result.file_name() != nullptr) {
            place = std::filesystem::path(result.file_name()).filename().string() + ":" +
                    std::to_string(result.line_number());
        }
        const auto known = std::ranges::find(*failures_, place, &Failure::place);
        if (known != failures_->end() && !place.empty()) {
            ++known->times;
        } else if (failures_->size() < mostFailures) {
            failures_->push_back({place, std::string(result.message()).substr(0, longestMessage)});
        }
    }

private:
    std::vector<Failure>* failures_;
};

std::string readWord(int descriptor) {
    std::string word;
    for (char c = 0; word.size() < longestWord && read(descriptor, &c, 1) == 1 && c != '\n';) word += c;
    return word;
}

void writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(descriptor, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string typeName(const std::type_info& type) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, &status),
                                                      std::free);
    return status == 0 ? name.get() : type.name();
}

// An assertion such as EXPECT_THROW(f(), InputError) swallows a stub's exception and reports it in its message.
bool reportsStub(const std::vector<Failure>& failures) {
    for (const Failure& failure : failures) {
        const std::size_t start = failure.message.find("exercise ex-");
        if (start != std::string::npos && failure.message.find("is not implemented yet", start) != std::string::npos) {
            return true;
        }
    }
    return false;
}

std::string verdictOnFinishedTest(bool passed, const std::vector<Failure>& failures) {
    const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
    if (unit.test_to_run_count() != 1) return "no such test";
    if (!passed) return reportsStub(failures) ? "not implemented" : "failed";
    return unit.skipped_test_count() > 0 ? "skipped" : "passed";
}

std::string runTest(std::vector<Failure>& failures) {
    try {
        return verdictOnFinishedTest(RUN_ALL_TESTS() == 0, failures);
    } catch (const NotImplemented& stub) {
        failures.push_back({"", stub.what()});
        return "not implemented";
    } catch (const std::exception& error) {
        failures.push_back({"", "threw " + typeName(typeid(error)) + ": " + error.what()});
    } catch (...) {
        failures.push_back({"", "threw something that is no std::exception"});
    }
    return "failed";
}

}  // namespace

std::optional<VerdictChannel> takeVerdictChannel(int& argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        std::string_view word = argv[i];
        if (!word.starts_with(option)) continue;
        word.remove_prefix(option.size());
        VerdictChannel channel;
        const auto comma = std::from_chars(word.begin(), word.end(), channel.in);
        if (comma.ec != std::errc() || comma.ptr == word.end()) return std::nullopt;
        if (std::from_chars(comma.ptr + 1, word.end(), channel.out).ec != std::errc()) return std::nullopt;
        for (int j = i; j < argc; ++j) argv[j] = argv[j + 1];
        --argc;
        return channel;
    }
    return std::nullopt;
}

int runForVerdict(const VerdictChannel& channel) {
    fcntl(channel.in, F_SETFD, FD_CLOEXEC);
    fcntl(channel.out, F_SETFD, FD_CLOEXEC);

    // An exception that leaves the test has to come here with its type.
    GTEST_FLAG_SET(catch_exceptions, false);
    std::vector<Failure> failures;
    testing::UnitTest::GetInstance()->listeners().Append(new FailureCollector(failures));
    const std::string verdict = runTest(failures);

    // Asked for now: while the test ran, the word was not in this process for anybody to find.
    writeAll(channel.out, question);
    const std::string word = readWord(channel.in);
    close(channel.in);

    nlohmann::ordered_json json = {{"word", word}, {"verdict", verdict}, {"failures", nlohmann::ordered_json::array()}};
    for (const Failure& failure : failures) {
        json["failures"].push_back({{"place", failure.place}, {"message", failure.message}, {"times", failure.times}});
    }
    writeAll(channel.out, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    close(channel.out);
    return verdict == "passed" ? 0 : 1;
}

}  // namespace caustic::test
