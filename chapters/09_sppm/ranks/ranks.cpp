#include "ranks/ranks.h"

#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

namespace caustic {

namespace {

constexpr int tag = 0;

// Until `done` says so. Short beside a pass, long beside the question.
template <typename Done>
void waitUntil(Done done) {
    constexpr std::chrono::microseconds pause(200);
    while (!done()) std::this_thread::sleep_for(pause);
}

}  // namespace

Ranks::Ranks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() { MPI_Finalize(); }

std::optional<Ranks::Outcome> Ranks::failure(int exitCode) const {
    constexpr int codes = 256;
    constexpr int none = std::numeric_limits<int>::max();
    const int own = exitCode == 0 ? none : rank_ * codes + exitCode;
    int lowest = none;
    MPI_Allreduce(&own, &lowest, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (lowest == none) return std::nullopt;
    return Outcome{lowest / codes, lowest % codes};
}

std::int64_t Ranks::shared(std::int64_t number) const {
    MPI_Bcast(&number, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
    return number;
}

std::vector<std::uint8_t> Ranks::anyOf(std::vector<std::uint8_t> flags) const {
    MPI_Allreduce(MPI_IN_PLACE, flags.data(), static_cast<int>(flags.size()), MPI_UINT8_T, MPI_LOR, MPI_COMM_WORLD);
    return flags;
}

void Ranks::send(const std::string& bytes) const {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw std::length_error("a pass of " + std::to_string(bytes.size()) + " bytes is more than MPI sends at once");
    // Synchronous: a small film would otherwise be buffered, and a quick rank would fill the memory of rank 0.
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Issend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, tag, MPI_COMM_WORLD, &request);
    waitUntil([&request] {
        int done = 0;
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        return done != 0;
    });
    MPI_Wait(&request, MPI_STATUS_IGNORE);  // returns at once
}

std::string Ranks::receive(int from) const {
    MPI_Status status;
    waitUntil([&status, from] {
        int there = 0;
        MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status);
        return there != 0;
    });
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    std::string bytes(static_cast<std::size_t>(count), '\0');
    MPI_Recv(bytes.data(), count, MPI_BYTE, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return bytes;
}

void Ranks::abort(int exitCode) const {
    // mpirun drops what it hasn't read yet of a rank's output when it is told to end the job.
    std::fflush(nullptr);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::abort();  // MPI_Abort isn't declared as one that doesn't return
}

}  // namespace caustic
