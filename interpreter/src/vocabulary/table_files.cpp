#include "vocabulary/table_files.hpp"

#include <utility>

namespace armlet {

TableFiles::TableFiles(const TableFiles* before) {
  if (before != nullptr) before_ = before->known_;
}

const TableFile& TableFiles::find(const ModuleLoader& load, const std::string& path,
                                  const std::string& from) {
  const auto [at, is_new] = known_.try_emplace({path, from});
  if (!is_new) return *at->second;
  TableFile file;
  if (load) file.found = load(path, from);
  if (file.found.text) {
    const auto old = before_.find({path, from});
    const bool is_same = old != before_.end() && old->second->text != nullptr &&
                         *old->second->text == *file.found.text;
    if (is_same) return *(at->second = old->second);
    file.text = std::make_shared<const std::string>(std::move(*file.found.text));
    file.found.text.reset();
    Result<TableText> table = read_table_text(*file.text);
    if (table.ok()) {
      std::vector<TableColumn> columns;
      for (const TableColumn& column : table.value().columns)
        columns.push_back({column.name, column.unit, column.dim, column.is_text});
      file.columns = std::move(columns);
    } else {
      file.columns = table.error();
    }
  }
  return *(at->second = std::make_shared<const TableFile>(std::move(file)));
}

}  // namespace armlet
