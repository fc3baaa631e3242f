#include "failures/print_leaks.h"

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "core/check.h"
#include "core/text.h"
#include "failures/leaks.h"

namespace caustic {

void printLeaks(const std::string& rays, std::uint64_t seed, int threads, std::ostream& out) {
    constexpr long long mostRays = 1'000'000'000;
    const long long count = parseInteger(rays).value_or(0);
    checkArgument(count >= 1 && count <= mostRays, "--leaks", rays, "must be a whole number from 1 to 1000000000");

    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const TriangleMethod& method : triangleMethods()) {
        for (const auto& [aim, name] : {std::pair(Aim::Edges, "edges"), std::pair(Aim::Vertices, "vertices")}) {
            const FailureCount found = countLeaks(method, aim, count, seed, threads);
            list.push_back({{"method", method.name}, {"aim", name}, {"leaks", found.failures}, {"rays", found.trials}});
        }
    }
    out << list.dump(1) << '\n';
}

}  // namespace caustic
