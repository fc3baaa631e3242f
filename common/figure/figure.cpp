#include "figure/figure.h"

#include <algorithm>

#include "core/error.h"
#include "figure/gnuplot.h"

namespace caustic {

namespace {

void addOnce(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::filesystem::path FigureContext::output(const std::string& file) {
    addOnce(outputs_, file);
    return options_->out / inputs_->name / file;
}

std::filesystem::path FigureContext::asset(const std::string& path) {
    if (!inputs_->assets.contains(path)) throw InputError({path, 0}, "", "the course has no such asset");
    addOnce(assets_, path);
    return inputs_->sourceDir / path;
}

void FigureContext::chart(const std::string& script, const std::string& png) {
    draw(inputs_->sourceDir / "chapters" / inputs_->name / script, png, "");
}

void FigureContext::sharedChart(const std::string& script, const std::string& png, const std::string& settings) {
    draw(inputs_->sourceDir / "common/figure" / script, png, settings);
}

void FigureContext::draw(const std::filesystem::path& script, const std::string& png, const std::string& settings) {
    const std::filesystem::path style = inputs_->sourceDir / "common/figure/style.gp";
    drawChart({style, script}, options_->out / inputs_->name, output(png), settings);
}

}  // namespace caustic
