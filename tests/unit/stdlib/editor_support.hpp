#pragma once
// What tests of editors share: the examples, their imports, their tokens, and what says a type.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "ast/ast_walk.hpp"
#include "editor/facts.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet::editor_test {

inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<std::filesystem::path> programs_below(const char* folder) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(ARMLET_ROOT) / folder)) {
    if (entry.path().extension() == ".rbt") out.push_back(entry.path());
  }
  std::ranges::sort(out);
  return out;
}

inline SessionOptions options_for(const std::filesystem::path& program) {
  SessionOptions out;
  out.default_world = table_world();
  out.load = [folder = program.parent_path()](const std::string& path, const std::string&) {
    ImportedText found{.name = path};
    if (std::filesystem::exists(folder / path)) found.text = read(folder / path);
    return found;
  };
  return out;
}

inline lang::Tokens tokens_of(const std::string& text) {
  const Source source("program.rbt", text);
  DiagnosticSink sink;
  return lang::lex(source, lang::program_range(source), sink, {}).tokens;
}

inline std::shared_ptr<const Analysis> analysis_of(const std::string& text) {
  Session session(library_engine(), {.default_world = table_world()});
  return session.analyse(text, "program.rbt");
}

inline bool offers(const Completions& completions, std::string_view text) {
  return std::ranges::any_of(completions.items, [&](const Completion& item) {
    return item.text == text ||
           (item.kind == NameKind::kSetting && item.text == std::string(text) + ':');
  });
}

// How much of a whole text with one file has to be written before it says what the type of a name
// is. Tests of texts that are cut off compare types only where they are said.
//
// A variable says its type with what is written as such or with its value, a parameter with what is
// written; one without a type gets it from the first call of its function, or of that which its
// lambda is given to. A function says what it gives where that is written, or with its body. What
// is inside of a function without written types is said with the first call of that too; and a
// value says nothing before the functions that it calls do. The columns of a recording are in its
// block.
class Said {
 public:
  explicit Said(const lang::Facts& facts) : facts_(facts) {
    for (const lang::ast::Stmt* stmt : facts.files.back().program.body) walk(*stmt);
  }

  // The byte behind it; the end of the text if it never is.
  [[nodiscard]] std::uint32_t until(const lang::Symbol& symbol) {
    return until(symbol.declared.begin);
  }

 private:
  struct Place {
    Span says{};                                        // the value or the whole that says it
    const lang::ast::FunctionStmt* by_calls = nullptr;  // and the first call of this one
  };

  static bool is_generic(const lang::ast::FunctionStmt& node) {
    return std::ranges::any_of(node.params, [](const auto& p) { return p.type == nullptr; });
  }

  void note(const lang::ast::Name& name, Span says) {
    places_[name.span.begin] = {says, inside_.empty() ? nullptr : inside_.back()};
  }

  void walk(const lang::ast::Stmt& stmt) {
    using lang::ast::StmtKind;
    const bool is_function = stmt.kind == StmtKind::kFunction;
    if (stmt.kind == StmtKind::kVar) {
      for (const lang::ast::Declarator& at : stmt.as<lang::ast::VarStmt>().declarators) {
        note(at.name, at.type != nullptr   ? at.type->span
                      : at.init != nullptr ? at.init->span
                                           : at.name.span);
      }
    } else if (stmt.kind == StmtKind::kForIn) {
      const auto& loop = stmt.as<lang::ast::ForInStmt>();
      const Span says = loop.type != nullptr ? loop.type->span : loop.items->span;
      note(loop.name, says);
      if (!loop.index.text.empty()) note(loop.index, says);
    } else if (stmt.kind == StmtKind::kStruct || stmt.kind == StmtKind::kEnum) {
      const auto& name = stmt.kind == StmtKind::kStruct ? stmt.as<lang::ast::StructStmt>().name
                                                        : stmt.as<lang::ast::EnumStmt>().name;
      note(name, stmt.span);
      if (stmt.kind == StmtKind::kStruct) {
        for (const lang::ast::Param& field : stmt.as<lang::ast::StructStmt>().fields)
          note(field.name, field.type != nullptr ? field.type->span : stmt.span);
      }
    } else if (stmt.kind == StmtKind::kRecord) {
      note(stmt.as<lang::ast::RecordStmt>().name, stmt.span);
    } else if (stmt.kind == StmtKind::kImport) {
      note(stmt.as<lang::ast::ImportStmt>().alias, stmt.span);
    } else if (is_function) {
      add_function(stmt.as<lang::ast::FunctionStmt>());
    }
    const bool is_generic_one = is_function && is_generic(stmt.as<lang::ast::FunctionStmt>());
    if (is_generic_one) inside_.push_back(&stmt.as<lang::ast::FunctionStmt>());
    lang::ast::for_each_part(
        stmt, [this](const lang::ast::Expr& e) { walk(e); },
        [this](const lang::ast::Stmt& s) { walk(s); });
    if (is_generic_one) inside_.pop_back();
  }

  void add_function(const lang::ast::FunctionStmt& node) {
    const lang::ast::FunctionStmt* by_calls = is_generic(node) ? &node : nullptr;
    for (const lang::ast::Param& param : node.params) {
      const bool is_typed = param.type != nullptr;
      places_[param.name.span.begin] = {is_typed ? param.type->span : param.name.span,
                                        is_typed ? nullptr : by_calls};
    }
    // Its header is shown, up to the body.
    const std::uint32_t body =
        node.body != nullptr ? node.body->span.begin : node.value->span.begin;
    const Type* result = facts_.learnt.result_of(node.name.span);
    const bool is_said = node.result != nullptr || node.classic;
    const bool gives = result != nullptr && !result->is(Kind::kVoid);
    places_[node.name.span.begin] = {
        {node.span.begin, is_said || !gives ? body : node.span.end, node.span.source},
        is_said || !gives ? nullptr : by_calls};
  }

  void walk(const lang::ast::Expr& expr) {
    if (expr.kind == lang::ast::ExprKind::kCall) calls_.push_back(expr.span);
    if (expr.kind == lang::ast::ExprKind::kLambda) {
      // The innermost call around it.
      Span call = expr.span;
      for (const Span around : calls_)
        if (around.begin <= expr.span.begin && expr.span.end <= around.end) call = around;
      for (const lang::ast::Param& param : expr.as<lang::ast::LambdaExpr>().params)
        note(param.name, param.type != nullptr ? param.type->span : call);
    }
    lang::ast::for_each_part(
        expr, [this](const lang::ast::Expr& e) { walk(e); },
        [this](const lang::ast::Stmt& s) { walk(s); });
  }

  [[nodiscard]] std::uint32_t first_call(const lang::ast::FunctionStmt& node) const {
    const lang::Symbol* symbol = facts_.declared_at(node.name.span);
    auto first = static_cast<std::uint32_t>(facts_.main().text().size());
    if (symbol == nullptr) return first;
    for (const lang::Reference& use : facts_.uses_of(*symbol)) {
      for (const Span call : calls_)
        if (call.begin <= use.name.begin && use.name.end < call.end && use.name != symbol->declared)
          first = std::min(first, call.end);
    }
    return first;
  }

  std::uint32_t until(std::uint32_t declared) {
    const auto found = places_.find(declared);
    if (found == places_.end()) return declared;
    // What needs itself is said by the rest.
    const auto [known, is_new] = until_.try_emplace(declared, declared);
    if (!is_new) return known->second;
    const Place& place = found->second;
    std::uint32_t out = place.says.end;
    if (place.by_calls != nullptr) out = std::max(out, first_call(*place.by_calls));
    for (const lang::Reference& use : facts_.names.references) {
      if (use.name.source != place.says.source || use.name.begin < place.says.begin ||
          use.name.end > place.says.end)
        continue;
      const lang::Symbol& symbol = facts_.names.symbols[use.symbol];
      if (symbol.declared.source == place.says.source)
        out = std::max(out, until(symbol.declared.begin));
    }
    until_[declared] = out;
    return out;
  }

  const lang::Facts& facts_;
  std::map<std::uint32_t, Place> places_;  // by the begin of the name
  std::map<std::uint32_t, std::uint32_t> until_;
  std::vector<Span> calls_;                             // outer ones first
  std::vector<const lang::ast::FunctionStmt*> inside_;  // without written types
};

}  // namespace armlet::editor_test
