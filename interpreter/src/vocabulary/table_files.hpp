#pragma once
// Files with tables as checks know them: each is asked for once and read once.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "armlet/interpreter/host/table_text.hpp"

namespace armlet {

// A table that a program reads with loadTable. If there is no text, `found` says why; it has no
// text here in any case.
struct TableFile {
  ImportedText found;
  std::shared_ptr<const std::string> text;                                // null: there is none
  Result<std::vector<TableColumn>> columns = std::vector<TableColumn>();  // without their cells
};

// One for all the checks of a text, trials included.
class TableFiles {
 public:
  TableFiles() = default;
  // before  of a text that is much alike: tables whose text is the same are not read again.
  explicit TableFiles(const TableFiles* before);

  // The table that the file `from` means by `path`. It stays where it is.
  const TableFile& find(const ModuleLoader& load, const std::string& path, const std::string& from);

 private:
  using Question = std::pair<std::string, std::string>;
  std::map<Question, std::shared_ptr<const TableFile>> known_;
  std::map<Question, std::shared_ptr<const TableFile>> before_;
};

}  // namespace armlet
