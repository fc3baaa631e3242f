#include "failures/print_leaks.h"

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "failures/leaks.h"

namespace caustic {

void printLeaks(std::int64_t rays, std::uint64_t seed, int threads, std::ostream& out) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const TriangleMethod& method : triangleMethods()) {
        for (const auto& [aim, name] : {std::pair(Aim::Edges, "edges"), std::pair(Aim::Vertices, "vertices")}) {
            const FailureCount found = countLeaks(method, aim, rays, seed, threads);
            list.push_back({{"method", method.name}, {"aim", name}, {"leaks", found.failures}, {"rays", found.trials}});
        }
    }
    out << list.dump(1) << '\n';
}

}  // namespace caustic
