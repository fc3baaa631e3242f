#include "failures/print_roots.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "failures/root_examination.h"

namespace caustic {

namespace {

nlohmann::ordered_json entryOf(const std::string& surface, const std::string& set, const RootExamination& count) {
    nlohmann::ordered_json entry = {{"surface", surface},
                                    {"set", set},
                                    {"rays", count.rays},
                                    {"meetings", count.meetings},
                                    {"misses", count.misses},
                                    {"falseHits", count.falseHits},
                                    {"raysInBand", count.raysInBand},
                                    {"worstDistance", count.worstDistance}};
    for (const NearestCount& method : count.nearest) {
        entry["nearest"][method.method] = {{"failures", method.failures}, {"trials", method.trials}};
    }
    return entry;
}

}  // namespace

void printRoots(std::int64_t rays, std::uint64_t seed, int threads, std::ostream& out) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto revolutionSets = revolutionSetNames();
    for (std::size_t set = 0; set < revolutionSets.size(); ++set) {
        const auto found = examineRevolution(set, set == 0 ? rays : rays / 10, seed, threads);
        list.push_back(entryOf("revolution", revolutionSets[set], found));
    }
    const auto patchSets = patchSetNames();
    for (std::size_t set = 0; set < patchSets.size(); ++set) {
        const auto found = examinePatches(set, set == 0 ? rays : rays / 10, seed, threads);
        list.push_back(entryOf("patch", patchSets[set], found));
    }
    out << list.dump(1) << '\n';
}

}  // namespace caustic
