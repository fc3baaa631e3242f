#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace caustic {

/// The processes of an MPI job, of which this one is a part, numbered from 0. There is one object of this kind in a
/// process, made before anything else and gone at the end.
///
/// Waiting takes no processor's time: MPI's own ways of waiting turn in circles, and would take it from those that
/// compute when there are more ranks than processors.
class Ranks {
public:
    /// Joins the job; alone when the program wasn't started by mpirun.
    Ranks();
    /// Leaves it, once all do.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// Which one this is.
    int rank() const { return rank_; }
    /// How many there are.
    int count() const { return count_; }
    /// Whether this is rank 0, which gathers what the others do.
    bool first() const { return rank_ == 0; }

    /// What came out on some rank.
    struct Outcome {
        int rank = 0;      ///< which
        int exitCode = 0;  ///< what it would end with
    };
    /// Lets all ranks know whether one of them has failed. Each has to call it.
    /// @param exitCode  of this one: 0 when all is well, at most 255
    /// @return that of the lowest rank that has failed; nothing when none has
    std::optional<Outcome> failure(int exitCode) const;

    /// A number that rank 0 has, for all. Each has to call it.
    std::int64_t shared(std::int64_t number) const;

    /// For each of some numbers, 1 when it isn't 0 on some rank. Each has to call it, with as many numbers.
    std::vector<std::uint8_t> anyOf(std::vector<std::uint8_t> flags) const;

    /// Sends bytes to rank 0, and waits until it takes them.
    /// @throws std::length_error when there are more than 2³¹ − 1
    void send(const std::string& bytes) const;

    /// Takes the next bytes that this rank sends; waits for them.
    std::string receive(int from) const;

    /// Ends all processes of the job at once.
    [[noreturn]] void abort(int exitCode) const;

private:
    int rank_ = 0;
    int count_ = 1;
};

}  // namespace caustic
