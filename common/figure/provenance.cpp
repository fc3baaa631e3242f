#include "figure/provenance.h"

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

constexpr std::size_t largestProvenance = std::size_t{16} << 20;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Linux can forget the peak so far; elsewhere the figure's peak is the whole run's.
void forgetPeakMemory() {
    std::ofstream file("/proc/self/clear_refs");
    file << "5";
}

double peakMemoryMiB() {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

// To hundredths, so that it is written as "0.95".
double hundredths(double value) { return std::round(value * 100) / 100; }

nlohmann::ordered_json readProvenance(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return nlohmann::ordered_json::object();
    auto json = nlohmann::ordered_json::parse(readTextFile(path, largestProvenance), nullptr, false);
    if (!json.is_object()) throw InputError({path.string(), 0}, "", "is no JSON object; remove it to make it anew");
    return json;
}

}  // namespace

CostMeter::CostMeter() : start_(now()) { forgetPeakMemory(); }

FigureCost CostMeter::cost() const { return {now() - start_, peakMemoryMiB()}; }

void recordProvenance(const ChapterInputs& inputs, const ChapterOptions& options, const Figure& figure,
                      const FigureContext& context, const FigureCost& cost) {
    const auto path = options.out / inputs.name / "provenance.json";
    auto json = readProvenance(path);
    json["chapter"] = inputs.name;
    auto& entry = json["figures"][figure.name];
    entry = nlohmann::ordered_json::object();
    entry["files"] = context.outputs();
    entry["inputs"]["sources"] = inputs.sourcesHash;
    for (const std::string& asset : context.assets()) entry["inputs"][asset] = inputs.assets.at(asset);
    entry["quality"] = options.quality == Quality::Draft ? "draft" : "report";
    entry["seed"] = options.seed;
    entry["threads"] = options.threads;
    entry["timed"] = figure.timed;
    entry["seconds"] = hundredths(cost.seconds);
    entry["peak_mib"] = std::round(cost.peakMiB);
    writeTextAtomically(path, json.dump(2) + "\n");
}

}  // namespace caustic
