#include "check/names/loaded_tables.hpp"

#include "armlet/interpreter/host/table_text.hpp"
#include "check/state/suggest.hpp"
#include "vocabulary/table_files.hpp"

namespace armlet::lang {
namespace {

// The value of a text parameter. Null: the argument is absent. `known` is false if the text of the
// program does not show it.
struct SaidText {
  Span span;
  bool known = false;
  std::string text{};
};
std::optional<SaidText> said_text(Checker& checker, const Signature& signature, const Fit& fit,
                                  const std::vector<Argument>& arguments, std::string_view name) {
  const int parameter = signature.index_of(name);
  const int from = parameter < 0 ? -1 : fit.from[static_cast<std::size_t>(parameter)];
  if (from < 0) return std::nullopt;
  const hir::Expr& value = *arguments[static_cast<std::size_t>(from)].value;
  std::optional<Constant> known = checker.shared.constants.of(value);
  if (!known || known->kind != Constant::Kind::kText) return SaidText{value.span};
  return SaidText{value.span, true, std::move(known->text)};
}

constexpr std::string_view kHow =
    "say what its columns are: columns: \"t [s], q1 [deg], part: string\", for example";

const Type* refuse_file(Checker& checker, Span span, const std::string& file, std::string why,
                        std::optional<Fix> fix) {
  Diagnostic diagnostic = make_diagnostic("E0126", span, {file, std::move(why)});
  diagnostic.fix = std::move(fix);
  checker.report(std::move(diagnostic));
  return nullptr;
}

// The columns of the file; null if the file cannot be read, which was reported.
const Type* columns_of_file(Checker& checker, const std::string& file, Span span,
                            std::vector<TableColumn>& columns) {
  const Checker& main = *checker.shared.files.back();
  const std::string from((*checker.into.sources)[main.file.program.span.source].name());
  if (!file.ends_with(kTableEnding)) {
    refuse_file(checker, span, file, "tables are read from " + std::string(kTableEnding) + " files",
                std::nullopt);
    return nullptr;
  }
  TableFiles asked_here;
  TableFiles& tables = checker.options.tables != nullptr ? *checker.options.tables : asked_here;
  const TableFile& table = tables.find(checker.options.load, file, from);
  if (table.text == nullptr) {
    const ImportedText& found = table.found;
    const std::vector<std::string_view> others(found.others.begin(), found.others.end());
    const auto meant = suggest(file, std::span<const std::string_view>(others));
    Fix fix{.text = "if the program writes it first, " + std::string(kHow)};
    if (meant) {
      const std::string better = '"' + std::string(*meant) + '"';
      fix = Fix{"did you mean " + better + "?", {{span, better}}, Confidence::kSure};
    }
    const std::string why = !checker.options.load ? "the host of this program gives it no files"
                            : found.why.empty()   ? "there is no such file"
                                                  : found.why;
    refuse_file(checker, span, file, why, std::move(fix));
    return nullptr;
  }
  if (!table.columns.ok())
    return refuse_file(checker, span, file, table.columns.error().message, std::nullopt);
  columns = table.columns.value();
  return checker.types.any();
}

const Type* refuse_columns(Checker& checker, Span span, std::string message, std::string why) {
  Diagnostic diagnostic = make_diagnostic("E0323", span, {"the columns of this table"});
  diagnostic.message = std::move(message);
  diagnostic.why = std::move(why);
  diagnostic.fix = Fix{.text = std::string(kHow)};
  checker.report(std::move(diagnostic));
  return nullptr;
}

}  // namespace

const Type* loaded_table(Checker& checker, const Signature& signature, const Fit& fit,
                         const std::vector<Argument>& arguments, Span span, std::string& columns) {
  std::vector<TableColumn> found;
  const auto said = said_text(checker, signature, fit, arguments, "columns");
  const auto file = said ? said : said_text(checker, signature, fit, arguments, "file");
  if (!file || !file->known) {
    return refuse_columns(checker, file ? file->span : span,
                          "the columns of this table are not known here",
                          said ? "the text does not show what `columns` is"
                               : "they are found in the file when the program is checked, and the "
                                 "text does not show which file it is");
  }
  if (said) {
    Result<std::vector<TableColumn>> read = read_columns_text(said->text);
    if (!read.ok())
      return refuse_columns(checker, said->span,
                            "these are no columns of a table: " + read.error().message, {});
    found = std::move(read).value();
  } else {
    if (columns_of_file(checker, file->text, file->span, found) == nullptr) return nullptr;
    columns = columns_text(found);
  }
  std::vector<RecordField> row;
  for (const TableColumn& column : found) {
    row.push_back({.name = column.name,
                   .type = column.is_text         ? checker.types.text()
                           : column.dim.is_none() ? checker.types.real()
                                                  : checker.types.quantity(column.dim)});
  }
  return checker.types.table(std::move(row));
}

}  // namespace armlet::lang
