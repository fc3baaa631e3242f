#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/random.h"
#include "figure/figure.h"

namespace caustic {

/// How often one method was wrong on one kind of case.
struct FailureRow {
    std::string method;
    std::string name;  ///< of the kind of case
    std::int64_t failures = 0;
    std::int64_t trials = 0;
    bool robust = false;  ///< whether it is said to get all of them right
};

/// A method that is tried on random cases.
struct TriedMethod {
    std::string name;
    bool robust = false;  ///< whether it is said to get all of them right
};

/// A kind of random case, and the methods that are tried on it.
struct FailureKind {
    std::string name;
    std::vector<TriedMethod> methods;
    /// Makes a case of the numbers and says of each method, in order, whether it gets it right. Called by many threads
    /// at once.
    std::function<std::vector<bool>(Random&)> right;
};

/// How many random cases of each kind are made, of which numbers, by how many threads.
struct FailureTrials {
    std::int64_t count;
    std::uint64_t seed;
    int threads = 1;               ///< at least 1; the counts don't depend on it
    Progress* progress = nullptr;  ///< what advances by one with each kind

    /// As a figure is to be drawn.
    static FailureTrials of(FigureContext& context, std::int64_t count) {
        return {count, context.seed(), context.threads(), &context.progress()};
    }
};

/// Counts failures; a row a method, kind by kind. Case i of each kind is made of the numbers of Random(seed, {i}).
std::vector<FailureRow> countFailures(const std::vector<FailureKind>& kinds, const FailureTrials& trials);

/// Of each answer, whether it is at most `tolerance` away from the truth. NaN never is.
std::vector<bool> within(double tolerance, double truth, std::initializer_list<double> answers);

/// Writes failure.csv (method, case, failures, trials) and draws failure.png: a bar a method, below the kind of case
/// that it was tried on. Rows of a kind have to stand together.
void drawFailureBars(const std::vector<FailureRow>& rows, FigureContext& context);

/// The same for many kinds, or shares from next to nothing to all: a row a kind, a mark a method, a logarithmic axis.
void drawFailureMarks(const std::vector<FailureRow>& rows, FigureContext& context);

}  // namespace caustic
