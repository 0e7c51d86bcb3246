#include "check/names/imports.hpp"

#include <algorithm>

#include "armlet/interpreter/resource.hpp"
#include "diagnostic/backticks.hpp"
#include "syntax/tokens/words.hpp"

namespace armlet::lang {
namespace {

std::string without_folders(std::string_view path) {
  return std::string(path.substr(path.find_last_of('/') + 1));
}

std::string without_ending(std::string name) {
  if (name.ends_with(".rbt")) name.resize(name.size() - 4);
  return name;
}

bool is_private(std::string_view name) { return name.starts_with('_'); }

// What an import calls its file when it has no `as`: the file's name without folders and ending.
std::string name_of(const ast::ImportStmt& stmt) {
  if (!stmt.alias.text.empty()) return std::string(stmt.alias.text);
  if (stmt.is_file) return without_ending(without_folders(stmt.path));
  return std::string(stmt.path.substr(stmt.path.find_last_of('.') + 1));
}

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

// Everything that other files may use, for suggestions.
std::vector<std::string_view> public_names(const Checker& file) {
  std::vector<std::string_view> names;
  for (const auto& [name, span] : file.top_level_names_) names.push_back(name);
  for (const auto& [name, function] : file.functions_) names.push_back(name);
  for (const auto& [name, type] : file.named_types_) names.push_back(name);
  std::erase_if(names, is_private);
  return names;
}

Span declaration_of(const Checker& file, std::string_view name) {
  if (const auto at = file.top_level_names_.find(name); at != file.top_level_names_.end())
    return at->second;
  if (const auto at = file.functions_.find(name); at != file.functions_.end())
    return at->second.node->name.span;
  if (const auto at = file.type_names_.find(name); at != file.type_names_.end()) return at->second;
  return {};
}

// Tells of a name that the file has not, or keeps for itself; false if all is well.
bool refuse_member(Checker& checker, const Checker& file, std::string_view import,
                   const ast::Name& member) {
  const Span declared = declaration_of(file, member.text);
  if (!declared.empty() && !is_private(member.text)) return false;
  const std::string whole = std::string(import) + '.' + std::string(member.text);
  if (!declared.empty()) {
    Diagnostic diagnostic = make_diagnostic("E0215", member.span, {whole, file_name(file)});
    diagnostic.related.push_back({declared, "declared here"});
    diagnostic.why = "names that begin with _ are for the file itself";
    checker.report(std::move(diagnostic));
    return true;
  }
  if (checker.syntax_failed_ || file.syntax_failed_ || !checker.told_.emplace(whole).second)
    return true;
  Diagnostic diagnostic = make_diagnostic("E0201", member.span, {whole});
  if (!checker.takes_errors()) {
    checker.report(std::move(diagnostic));
    return true;
  }
  const std::vector<std::string_view> names = public_names(file);
  if (const auto meant = suggest(member.text, std::span<const std::string_view>(names))) {
    const std::string better = std::string(import) + '.' + std::string(*meant);
    diagnostic.fix = Fix{.text = "did you mean " + in_backticks(better) + ", declared on " +
                                 line_phrase(checker, declaration_of(file, *meant)) + "?",
                         .edits = {{member.span, std::string(*meant)}}};
  } else if (names.empty()) {
    diagnostic.why = file_name(file) + " declares nothing that other files may use";
  }
  checker.report(std::move(diagnostic));
  return true;
}

}  // namespace

bool is_main_file(const Checker& checker) { return checker.shared_.files.back() == &checker; }

std::string file_name(const Checker& checker) {
  return without_folders((*checker.into_.sources)[checker.program_.span.source].name());
}

std::string line_phrase(const Checker& checker, Span span) {
  std::string out = "line " + std::to_string(checker.line_of(span));
  if (span.source != checker.program_.span.source)
    out += " of " + without_folders((*checker.into_.sources)[span.source].name());
  return out;
}

// ---- names -------------------------------------------------------------------------------------

void bind_imports(Checker& checker) {
  for (const FileTree::Import& import : checker.file_.imports) {
    const ast::ImportStmt& stmt = *import.statement;
    checker.sink_.begin_statement();
    const std::string name = name_of(stmt);
    const bool is_word = std::ranges::all_of(name, is_word_character) && !name.empty() &&
                         (name[0] < '0' || name[0] > '9') && !is_reserved_word(name);
    if (!is_word) {
      report_no_name(checker, stmt, name);
      continue;
    }
    const Span shown = stmt.alias.text.empty() ? stmt.path_span : stmt.alias.span;
    Checker* file = import.file < 0 ? nullptr : checker.shared_.files[import.file];
    const auto [first, fresh] =
        checker.imports_.try_emplace(checker.arena_.copy(name), Import{shown, file});
    if (fresh) continue;
    Diagnostic diagnostic = make_diagnostic("E0204", shown, {name});
    diagnostic.mark.label = "imported under the same name";
    diagnostic.related.push_back({first->second.span, "first declared here"});
    diagnostic.fix = Fix{.text = "choose another name with as"};
    checker.report(std::move(diagnostic));
  }
}

Import* find_import(Checker& checker, std::string_view name) {
  const auto found = checker.imports_.find(name);
  return found == checker.imports_.end() ? nullptr : &found->second;
}

hir::Expr* imported_member(Checker& checker, const Import& from, const ast::MemberExpr& member,
                           const Type* expected) {
  const std::string_view name = member.member.text;
  if (from.file == nullptr) return checker.failed(member.span);
  Checker& file = *from.file;
  const std::string import = checker.text_of(member.object->span);
  if (refuse_member(checker, file, import, member.member)) return checker.failed(member.span);
  if (Local* local = file.main_.find(name)) return checker.read(*local, file.main_, member.span);
  if (FunctionDecl* function = file.find_function(name))
    return checker.function_value(*function, expected, member.span);
  if (file.named_types_.contains(name))
    checker.report(
        make_diagnostic("E0219", member.span, {import + '.' + std::string(name), "type"}));
  return checker.failed(member.span);  // its declaration failed, which was told
}

hir::Expr* call_imported(Checker& checker, const Import& from, const ast::CallExpr& call,
                         const ast::MemberExpr& member) {
  const std::string_view name = member.member.text;
  const Span callee = member.member.span;
  if (from.file == nullptr) return checker.failed(call.span);
  Checker& file = *from.file;
  const std::string import = checker.text_of(member.object->span);
  if (refuse_member(checker, file, import, member.member)) return checker.failed(call.span);
  if (FunctionDecl* function = file.find_function(name)) {
    return checker.call_script(*function, callee, call.span, checker.arguments_of(call.args, name));
  }
  if (const auto type = file.named_types_.find(name);
      type != file.named_types_.end() && type->second->is(Kind::kRecord)) {
    return checker.construct(checker.structs_[type->second->record], callee, call.span,
                             checker.arguments_of(call.args, name));
  }
  return checker.call_value(imported_member(checker, from, member, nullptr), call);
}

const FunctionDecl* imported_function(Checker& checker, const ast::Expr& expr) {
  if (expr.kind != ast::ExprKind::kMember) return nullptr;
  const auto& member = expr.as<ast::MemberExpr>();
  const Import* from = find_import(checker, checker.dotted_name(*member.object));
  if (from == nullptr || from->file == nullptr || is_private(member.member.text)) return nullptr;
  return from->file->find_function(member.member.text);
}

const Type* declared_type(Checker& checker, std::string_view name) {
  const std::size_t point = name.find('.');
  const Checker* file = &checker;
  if (point != std::string_view::npos) {
    const Import* from = find_import(checker, name.substr(0, point));
    if (from == nullptr || from->file == nullptr) return nullptr;
    file = from->file;
    name.remove_prefix(point + 1);
    if (is_private(name)) return nullptr;
  }
  const auto found = file->named_types_.find(name);
  return found == file->named_types_.end() ? nullptr : found->second;
}

std::string imported_name(const Checker& checker, std::string_view name) {
  if (is_private(name)) return {};
  for (const auto& [import, from] : checker.imports_) {
    if (from.file != nullptr && !declaration_of(*from.file, name).empty())
      return std::string(import) + '.' + std::string(name);
  }
  return {};
}

const Type* imported_type(Checker& checker, const ast::TypeExpr& type) {
  const ast::Name& first = type.path[0];
  const Import* from = find_import(checker, first.text);
  if (from == nullptr) {
    if (checker.syntax_failed_ || !checker.told_.emplace(first.text).second)
      return checker.types_.any();
    std::vector<std::string_view> names;
    for (const auto& [name, import] : checker.imports_) names.push_back(name);
    Diagnostic diagnostic = make_diagnostic("E0216", type.span, {checker.text_of(type.span)});
    diagnostic.why = "no file is imported under the name " + in_backticks(first.text);
    diagnostic.fix = checker.did_you_mean(first.text, first.span, names);
    checker.report(std::move(diagnostic));
    return checker.types_.any();
  }
  if (from->file == nullptr) return checker.types_.any();
  const std::string whole = checker.text_of(type.span);
  if (const Type* found = type.path.size() == 2 ? declared_type(checker, whole) : nullptr)
    return found;
  if (refuse_member(checker, *from->file, first.text, type.path[1])) return checker.types_.any();
  checker.report(make_diagnostic("E0216", type.span, {whole}));
  return checker.types_.any();
}

FunctionDecl* method_of(Checker& checker, const Type* type, std::string_view name) {
  const auto home = checker.shared_.homes.find(type);
  if (home == checker.shared_.homes.end() || home->second == &checker || is_private(name))
    return nullptr;
  return home->second->find_function(name);
}

void refuse_change(Checker& checker, const ast::Expr& place, Span statement) {
  const std::string whole = checker.text_of(place.span);
  Diagnostic diagnostic = make_diagnostic("E0206", statement, {whole});
  diagnostic.why = "variables of an imported file can be changed in that file only";
  const std::string import = whole.substr(0, whole.find('.'));
  const Import* from = find_import(checker, import);
  if (from == nullptr || from->file == nullptr) return;
  diagnostic.fix = Fix{.text = "write a function in " + file_name(*from->file) +
                               " that changes it, and call it here"};
  checker.report(std::move(diagnostic));
}

void refuse_second_owner(Checker& checker, const ast::ObjectStmt& stmt, const Type* type) {
  if (!type->is(Kind::kHost)) return;
  const std::string name(stmt.name.text);
  for (Checker* file : checker.shared_.files) {
    if (file == &checker) return;
    const Local* other = file->main_.find(stmt.name.text);
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
  if (is_main_file(checker) || checker.here_ != &checker.main_ || checker.main_.blocks.size() > 1)
    return false;
  switch (stmt.kind) {
    case ast::StmtKind::kEmpty:
    case ast::StmtKind::kVar:
    case ast::StmtKind::kObject:
    case ast::StmtKind::kFunction:
    case ast::StmtKind::kStruct:
    case ast::StmtKind::kEnum:
    case ast::StmtKind::kImport:
    case ast::StmtKind::kTest:
      return false;
    default:
      return true;
  }
}

void check_active_statement(Checker& checker, const ast::Stmt& stmt) {
  Use used;
  Use* const before = std::exchange(checker.use_, &used);
  checker.open_block();  // so that it is no statement of the top level
  (void)checker.check_statement(stmt);
  checker.close_block();
  checker.use_ = before;
  checker.active_statements_.emplace_back(stmt.span, std::move(used));
}

namespace {

// The import that brought the file into the program: its first one.
struct Importer {
  const Checker* file = nullptr;
  Span span{};
};

Importer importer_of(const Checker& file) {
  for (const Checker* other : file.shared_.files) {
    for (const FileTree::Import& import : other->file_.imports) {
      if (import.file >= 0 && file.shared_.files[import.file] == &file)
        return {other, import.statement->span};
    }
  }
  return {};
}

// "run a motor", in the words of the host.
std::string what_acts(const Checker& file) {
  for (const auto& [name, type] : file.registry_.types()) {
    if (type->resource != nullptr) return std::string(type->resource->act_on_one);
  }
  return "let time pass";
}

void refuse(Checker& file, Span statement, bool moves) {
  file.sink_.begin_statement();
  if (!file.takes_errors()) return;
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
  for (auto& [span, used] : checker.active_statements_)
    refuse(checker, span, checker.may_pause(used));
  for (const auto& [variable, init] : checker.top_level_) {
    if (init->span.source != checker.program_.span.source) continue;
    const auto used = checker.init_uses_.find(variable);
    if (used != checker.init_uses_.end() && checker.may_pause(used->second))
      refuse(checker, init->span, true);
  }
}

void run_imports_first(Checker& main) {
  std::vector<hir::Stmt*> body;
  for (const Checker* file : main.shared_.files) {
    if (file == &main || file->main_.function->body->body.empty()) continue;
    const Span span = importer_of(*file).span;
    hir::Expr* call = main.make<hir::CallExpr>(hir::ExprKind::kCall, main.types_.void_type(), span,
                                               file->main_.function, hir::Seq<hir::Expr*>{},
                                               hir::CallSite{span, span, {}});
    body.push_back(main.make<hir::ExprStmt>(hir::StmtKind::kExpr, span, call));
  }
  if (body.empty()) return;
  hir::Block& program = *main.main_.function->body;
  body.insert(body.end(), program.body.begin(), program.body.end());
  program.body = main.seq(body);
}

}  // namespace armlet::lang
