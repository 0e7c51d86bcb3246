#include "check/types/any_table.hpp"

namespace armlet::lang {

bool is_any_table(const Checker& checker, const ast::TypeExpr* type) {
  while (type != nullptr && type->form == ast::TypeForm::kArray) type = type->element;
  return type != nullptr && type->form == ast::TypeForm::kNamed && type->path.size() == 1 &&
         type->path[0].text == "table" && checker.names.find_type("table") == nullptr;
}

const Type* resolve_open(Checker& checker, const ast::TypeExpr* type) {
  return type == nullptr || is_any_table(checker, type) ? nullptr : checker.resolve(*type);
}

bool fits_any_table(const ast::TypeExpr* type, const Type* given) {
  for (; type->form == ast::TypeForm::kArray; type = type->element) {
    if (!given->is(Kind::kList)) return given->is(Kind::kAny);
    given = given->element;
  }
  return given->is_table() || given->is(Kind::kAny);
}

std::string any_table_phrase(const ast::TypeExpr* type) {
  std::string out = "a table";
  for (; type->form == ast::TypeForm::kArray; type = type->element) out += "[]";
  return out;
}

std::string table_phrase(const Type* type) {
  const std::string name = type_phrase(type);
  while (type->is(Kind::kList)) type = type->element;
  if (!type->is_table()) return "";
  std::string columns;
  const std::vector<RecordField>& fields = type->record->fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    columns += (i == 0 ? "" : i + 1 < fields.size() ? ", " : " and ") + fields[i].name;
  }
  return name + " of " + columns;
}

}  // namespace armlet::lang
