#pragma once
// The tables in files that a program loads, for the checker: each file is requested and parsed
// once.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "armlet/interpreter/host/table_text.hpp"

namespace armlet {

// A table that a program loads with loadTable. `found` has the reason if there is no text; the text
// itself is not in it.
struct TableFile {
  ImportedText found;
  std::shared_ptr<const std::string> text;                                // null: none
  Result<std::vector<TableColumn>> columns = std::vector<TableColumn>();  // without their cells
};

// Shared by all checks of a text, including trials.
class TableFiles {
 public:
  TableFiles() = default;
  // before  the tables of a similar text: those with the same contents are not parsed again.
  explicit TableFiles(const TableFiles* before);

  // The table for a `path` in the file `from`. Its address does not change.
  const TableFile& find(const ModuleLoader& load, const std::string& path, const std::string& from);

 private:
  using Question = std::pair<std::string, std::string>;
  std::map<Question, std::shared_ptr<const TableFile>> known_;
  std::map<Question, std::shared_ptr<const TableFile>> before_;
};

}  // namespace armlet
