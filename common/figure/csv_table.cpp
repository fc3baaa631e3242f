#include "figure/csv_table.h"

#include "core/atomic_file.h"
#include "core/check.h"

namespace caustic {

namespace {

std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell) {
        if (c == '"') text += '"';
        text += c;
    }
    return text + "\"";
}

void appendLine(std::string& text, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) text += ',';
        text += quoted(cells[i]);
    }
    text += '\n';
}

}  // namespace

CsvTable::CsvTable(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void CsvTable::addCells(std::vector<std::string> cells) {
    checkArgument(cells.size() == columns_.size(), "CSV row", std::to_string(cells.size()),
                  "must have " + std::to_string(columns_.size()) + " cells");
    rows_.push_back(std::move(cells));
}

std::string CsvTable::text() const {
    std::string text;
    appendLine(text, columns_);
    for (const auto& row : rows_) appendLine(text, row);
    return text;
}

void CsvTable::save(const std::filesystem::path& path) const { writeTextAtomically(path, text()); }

}  // namespace caustic
