#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <vector>

#include "core/text.h"

namespace caustic {

/// A table with named columns that ends up as a CSV file (RFC 4180: quotes only where needed, lines end in \n).
///
/// Every chart is drawn from such a file, so that whoever doubts a picture can look at its numbers.
class CsvTable {
public:
    /// An empty table with these column names.
    explicit CsvTable(std::vector<std::string> columns);

    /// Appends a row; numbers are written so that they read back exactly.
    /// @throws InputError unless there is one cell for each column
    template <typename... Cells>
    void addRow(const Cells&... cells) {
        addCells({cellText(cells)...});
    }

    /// Column names, from left to right.
    const std::vector<std::string>& columns() const { return columns_; }
    /// Cells as they are written, row by row.
    const std::vector<std::vector<std::string>>& rows() const { return rows_; }

    /// The whole file, column names first.
    std::string text() const;

    /// Writes the table through a temporary file and a rename.
    void save(const std::filesystem::path& path) const;

private:
    void addCells(std::vector<std::string> cells);

    static std::string cellText(const std::string& text) { return text; }
    static std::string cellText(const char* text) { return text; }
    static std::string cellText(std::floating_point auto value) { return formatReal(static_cast<double>(value)); }
    static std::string cellText(std::integral auto value) { return std::to_string(value); }

    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace caustic
