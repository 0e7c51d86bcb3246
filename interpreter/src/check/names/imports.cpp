#include "check/names/imports.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "armlet/interpreter/resource.hpp"
#include "base/diagnostic/backticks.hpp"
#include "base/words.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/names/variables.hpp"

namespace armlet::lang {
namespace {

std::string without_ending(std::string name) {
  if (name.ends_with(".rbt")) name.resize(name.size() - 4);
  return name;
}

bool is_private(std::string_view name) { return name.starts_with('_'); }

void report_no_name(Checker& checker, const ast::ImportStmt& stmt, const std::string& name) {
  std::string better;
  for (const char c : name) {
    const bool fits = is_word_character(c);
    if (fits) better += c;
    if (!fits && !better.empty() && better.back() != '_') better += '_';
  }
  const std::size_t first = better.find_first_not_of("0123456789_");
  better = first == std::string::npos ? "file" : better.substr(first);
  if (is_reserved_word(better)) better += "File";
  const Span end{stmt.path_span.end, stmt.path_span.end, stmt.path_span.source};
  Diagnostic diagnostic = make_diagnostic("E0222", stmt.path_span, {name});
  diagnostic.fix =
      Fix{.text = "give it a name: import " + checker.text_of(stmt.path_span) + " as " + better,
          .edits = {{end, " as " + better}},
          .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
}

// The names that other files may use, for proposals.
std::vector<std::string_view> public_names(const Checker& file) {
  std::vector<std::string_view> names = file.names.all();
  std::erase_if(names, is_private);
  return names;
}

}  // namespace

bool refuse_member(Checker& checker, const Checker& file, std::string_view import,
                   const ast::Name& member) {
  const Span declared = file.names.declaration_of(member.text);
  if (!declared.empty() && !is_private(member.text)) return false;
  const std::string whole = std::string(import) + '.' + std::string(member.text);
  if (!declared.empty()) {
    Diagnostic diagnostic = make_diagnostic("E0215", member.span, {whole, file_name(file)});
    diagnostic.related.push_back({declared, "declared here"});
    diagnostic.why = "names that begin with _ are for the file itself";
    checker.report(std::move(diagnostic));
    return true;
  }
  if (file.messages.syntax_failed() || !checker.messages.is_news(whole)) return true;
  Diagnostic diagnostic = make_diagnostic("E0201", member.span, {whole});
  if (!checker.messages.takes_errors()) {
    checker.report(std::move(diagnostic));
    return true;
  }
  const std::vector<std::string_view> names = public_names(file);
  if (const auto meant = suggest(member.text, std::span<const std::string_view>(names))) {
    const std::string better = std::string(import) + '.' + std::string(*meant);
    diagnostic.fix = Fix{.text = "did you mean " + in_backticks(better) + ", declared on " +
                                 line_phrase(checker, file.names.declaration_of(*meant)) + "?",
                         .edits = {{member.span, std::string(*meant)}}};
  } else if (names.empty()) {
    diagnostic.why = file_name(file) + " declares nothing that other files may use";
  }
  checker.report(std::move(diagnostic));
  return true;
}

std::string imported_as(const ast::ImportStmt& stmt) {
  if (!stmt.alias.text.empty()) return std::string(stmt.alias.text);
  if (stmt.is_file)
    return without_ending(std::string(stmt.path.substr(stmt.path.find_last_of('/') + 1)));
  return std::string(stmt.path.substr(stmt.path.find_last_of('.') + 1));
}

// ---- names -------------------------------------------------------------------------------------

void bind_imports(Checker& checker) {
  for (const FileTree::Import& import : checker.file.imports) {
    const ast::ImportStmt& stmt = *import.statement;
    checker.messages.begin_statement();
    const std::string name = imported_as(stmt);
    const bool is_word = std::ranges::all_of(name, is_word_character) && !name.empty() &&
                         (name[0] < '0' || name[0] > '9') && !is_reserved_word(name);
    if (!is_word) {
      report_no_name(checker, stmt, name);
      continue;
    }
    const Span shown = stmt.alias.text.empty() ? stmt.path_span : stmt.alias.span;
    Checker* file = import.file >= 0         ? checker.shared.files[import.file]
                    : import.kept != nullptr ? &checker.shared.earlier.file(*import.kept)
                                             : nullptr;
    const auto [first, fresh] =
        checker.names.add_import(checker.arena.copy(name), Import{shown, file});
    if (fresh) continue;
    Diagnostic diagnostic = make_diagnostic("E0204", shown, {name});
    diagnostic.mark.label = "imported under the same name";
    diagnostic.related.push_back({first->span, "first declared here"});
    diagnostic.fix = Fix{.text = "choose another name with as"};
    checker.report(std::move(diagnostic));
  }
}

const FunctionDecl* imported_function(Checker& checker, const ast::Expr& expr) {
  if (expr.kind != ast::ExprKind::kMember) return nullptr;
  const auto& member = expr.as<ast::MemberExpr>();
  const Import* from = checker.names.find_import(dotted_name(checker, *member.object));
  if (from == nullptr || from->file == nullptr || is_private(member.member.text)) return nullptr;
  return from->file->names.find_function(member.member.text);
}

const Type* declared_type(Checker& checker, std::string_view name) {
  const std::size_t point = name.find('.');
  const Checker* file = &checker;
  if (point != std::string_view::npos) {
    const Import* from = checker.names.find_import(name.substr(0, point));
    if (from == nullptr || from->file == nullptr) return nullptr;
    file = from->file;
    name.remove_prefix(point + 1);
    if (is_private(name)) return nullptr;
  }
  return file->names.find_type(name);
}

std::string imported_name(const Checker& checker, std::string_view name) {
  if (is_private(name)) return {};
  for (const auto& [import, from] : checker.names.imports()) {
    if (from.file != nullptr && !from.file->names.declaration_of(name).empty())
      return std::string(import) + '.' + std::string(name);
  }
  return {};
}

const Type* imported_type(Checker& checker, const ast::TypeExpr& type) {
  const ast::Name& first = type.path[0];
  const Import* from = checker.names.find_import(first.text);
  if (from == nullptr) {
    if (!checker.messages.is_news(first.text)) return checker.types.any();
    std::vector<std::string_view> names;
    for (const auto& [name, import] : checker.names.imports()) names.push_back(name);
    Diagnostic diagnostic = make_diagnostic("E0216", type.span, {checker.text_of(type.span)});
    diagnostic.why = "no file is imported under the name " + in_backticks(first.text);
    diagnostic.fix = did_you_mean(checker, first.text, first.span, names);
    checker.report(std::move(diagnostic));
    return checker.types.any();
  }
  if (from->file == nullptr) return checker.types.any();
  const std::string whole = checker.text_of(type.span);
  if (const Type* found = type.path.size() == 2 ? declared_type(checker, whole) : nullptr) {
    note_type_use(checker, *found, type.span);
    return found;
  }
  if (refuse_member(checker, *from->file, first.text, type.path[1])) return checker.types.any();
  checker.report(make_diagnostic("E0216", type.span, {whole}));
  return checker.types.any();
}

FunctionDecl* method_of(Checker& checker, const Type* type, std::string_view name) {
  Checker* const home = checker.shared.structs.home(type);
  if (home == nullptr || home == &checker || is_private(name)) return nullptr;
  return home->names.find_function(name);
}

void refuse_change(Checker& checker, const ast::Expr& place, Span statement) {
  const std::string whole = checker.text_of(place.span);
  Diagnostic diagnostic = make_diagnostic("E0206", statement, {whole});
  diagnostic.why = "variables of an imported file can be changed in that file only";
  const std::string import = whole.substr(0, whole.find('.'));
  const Import* from = checker.names.find_import(import);
  if (from == nullptr || from->file == nullptr) return;
  diagnostic.fix = Fix{.text = "write a function in " + file_name(*from->file) +
                               " that changes it, and call it here"};
  checker.report(std::move(diagnostic));
}

void refuse_second_owner(Checker& checker, const ast::ObjectStmt& stmt, const Type* type) {
  if (!type->is(Kind::kHost)) return;
  const std::string name(stmt.name.text);
  for (Checker* file : checker.shared.files) {
    if (file == &checker) return;
    const Local* other = file->scopes.main().find(stmt.name.text);
    if (other == nullptr || other->how != Declared::kBlock || other->variable->type != type)
      continue;
    Diagnostic diagnostic = make_diagnostic("E0512", stmt.name.span, {type_phrase(type), name});
    diagnostic.mark.label = "declared again";
    diagnostic.related.push_back({other->variable->declared, "first declared here"});
    diagnostic.fix = Fix{.text = "choose another name"};
    checker.report(std::move(diagnostic));
    return;
  }
}

// ---- what an imported file may contain ----------------------------------------------------------

bool is_active_statement(const Checker& checker, const ast::Stmt& stmt) {
  if (is_main_file(checker) || &checker.scopes.here() != &checker.scopes.main() ||
      checker.scopes.main().blocks.size() > 1)
    return false;
  using ast::StmtKind;
  constexpr std::array kDeclarations = {StmtKind::kEmpty,    StmtKind::kVar,    StmtKind::kObject,
                                        StmtKind::kFunction, StmtKind::kStruct, StmtKind::kEnum,
                                        StmtKind::kImport,   StmtKind::kTest};
  return std::ranges::find(kDeclarations, stmt.kind) == kDeclarations.end();
}

void check_active_statement(Checker& checker, const ast::Stmt& stmt) {
  Use used;
  Use& before = checker.scopes.collect_in(used);
  checker.scopes.open_block();  // so that it is not a statement of the top level
  (void)checker.check_statement(stmt);
  close_block(checker);
  checker.scopes.collect_in(before);
  checker.postponed.add_active(stmt.span, std::move(used));
}

namespace {

// The first import of a file.
struct Importer {
  const Checker* file = nullptr;
  Span span{};
};

Importer importer_of(const Checker& file) {
  for (const Checker* other : file.shared.files) {
    for (const FileTree::Import& import : other->file.imports) {
      if (import.file >= 0 && file.shared.files[import.file] == &file)
        return {other, import.statement->span};
    }
  }
  return {};
}

// The action of a host that an imported file must not do, as in "run a motor".
std::string what_acts(const Checker& file) {
  for (const auto& [name, type] : file.registry.types()) {
    if (type->resource != nullptr) return std::string(type->resource->act_on_one);
  }
  return "let time pass";
}

void refuse(Checker& file, Span statement, bool moves) {
  file.messages.begin_statement();
  if (!file.messages.takes_errors()) return;
  const Importer by = importer_of(file);
  const std::string importer = file_name(*by.file);
  Diagnostic diagnostic = moves ? make_diagnostic("E0504", statement, {what_acts(file)})
                                : make_diagnostic("E0221", statement);
  diagnostic.mark.label = "top level of " + file_name(file) + ", imported from " + importer + ':' +
                          std::to_string(by.file->line_of(by.span));
  diagnostic.fix = Fix{.text = "put this line inside a function and call it from " + importer};
  file.report(std::move(diagnostic));
}

}  // namespace

void refuse_active_statements(Checker& checker) {
  if (is_main_file(checker)) return;
  for (const auto& [span, used] : checker.postponed.active())
    refuse(checker, span, checker.shared.uses.may_pause(used));
  for (const auto& [variable, init] : checker.shared.top_level.entries()) {
    if (init->span.source != checker.file.program.span.source) continue;
    const Use* const used = checker.shared.top_level.use_of(variable);
    if (used != nullptr && checker.shared.uses.may_pause(*used)) refuse(checker, init->span, true);
  }
}

void run_imports_first(Checker& main) {
  std::vector<hir::Stmt*> body;
  for (const Checker* file : main.shared.files) {
    if (file == &main || file->scopes.main().function->body->body.empty()) continue;
    const Span span = importer_of(*file).span;
    hir::Expr* call = main.make<hir::CallExpr>(hir::ExprKind::kCall, main.types.void_type(), span,
                                               file->scopes.main().function, hir::Seq<hir::Expr*>{},
                                               hir::CallSite{span, span, {}});
    body.push_back(main.make<hir::ExprStmt>(hir::StmtKind::kExpr, span, call));
  }
  if (body.empty()) return;
  hir::Block& program = *main.scopes.main().function->body;
  body.insert(body.end(), program.body.begin(), program.body.end());
  program.body = main.seq(body);
}

}  // namespace armlet::lang
