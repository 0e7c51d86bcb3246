#include "syntax_dump.hpp"

#include <doctest/doctest.h>

#include "armlet/interpreter/render.hpp"

namespace armlet::lang {
namespace {

class TreeDump {
 public:
  std::string program(const Parsed& parsed) {
    for (const ast::Stmt* stmt : parsed.statements) {
      statement(stmt);
      out_ += '\n';
    }
    return std::move(out_);
  }

 private:
  template <class... Parts>
  void add(Parts&&... parts) {
    (out_.append(parts), ...);
  }

  template <class Items, class Show>
  void list(const char* head, const Items& items, Show show) {
    add("(", head);
    for (const auto& item : items) {
      out_ += ' ';
      show(item);
    }
    out_ += ')';
  }

  void values(const char* head, ast::Seq<ast::Expr*> items) {
    list(head, items, [&](const ast::Expr* item) { value(item); });
  }

  void args(ast::Seq<ast::Arg> items) {
    list("args", items, [&](const ast::Arg& arg) {
      if (!arg.name.text.empty()) add(arg.name.text, ":");
      value(arg.value);
    });
  }

  void params(const char* head, ast::Seq<ast::Param> items) {
    list(head, items, [&](const ast::Param& param) {
      add(param.name.text, ":");
      type(param.type);
      if (param.default_value != nullptr) value(param.default_value);
    });
  }

  void type(const ast::TypeExpr* expr) {
    if (expr == nullptr) return add("?");
    switch (expr->form) {
      case ast::TypeForm::kVoid:
        return add("void");
      case ast::TypeForm::kArray:
        type(expr->element);
        return add("[]");
      case ast::TypeForm::kMap:
        type(expr->element);
        add("[");
        type(expr->key);
        return add("]");
      case ast::TypeForm::kProduct:
        return list("product", expr->factors, [&](const ast::TypeFactor& factor) {
          type(factor.type);
          add("^", std::to_string(factor.exponent));
        });
      case ast::TypeForm::kFunction:
        list("fn", expr->parameters, [&](const ast::TypeExpr* one) { type(one); });
        add("->");
        return type(expr->result);
      default:
        for (std::size_t i = 0; i < expr->path.size(); ++i)
          add(i == 0 ? "" : ".", expr->path[i].text);
    }
  }

  void value(const ast::Expr* expr) {
    if (expr == nullptr) return add("-");
    out_.append(expr->parens, '(');
    plain_value(expr);
    out_.append(expr->parens, ')');
  }

  void plain_value(const ast::Expr* expr) {
    using K = ast::ExprKind;
    switch (expr->kind) {
      case K::kInt:
        return add(std::to_string(expr->as<ast::IntExpr>().value));
      case K::kReal:
        return add(std::to_string(expr->as<ast::RealExpr>().value));
      case K::kQuantity:
        return add(std::to_string(expr->as<ast::QuantityExpr>().number),
                   expr->as<ast::QuantityExpr>().unit);
      case K::kText:
        return add("'", expr->as<ast::TextExpr>().value, "'");
      case K::kBool:
        return add(expr->as<ast::BoolExpr>().value ? "true" : "false");
      case K::kName:
        return add(expr->as<ast::NameExpr>().name);
      case K::kFormatted:
        return formatted(expr->as<ast::FormattedExpr>());
      case K::kList:
        return values("list", expr->as<ast::ListExpr>().items);
      case K::kBrace:
        return values("brace", expr->as<ast::BraceExpr>().items);
      case K::kMap:
        values("keys", expr->as<ast::MapExpr>().keys);
        return values("values", expr->as<ast::MapExpr>().values);
      case K::kMatrix:
        return list("matrix", expr->as<ast::MatrixExpr>().rows,
                    [&](ast::Seq<ast::Expr*> row) { values("row", row); });
      case K::kLambda:
        return lambda(expr->as<ast::LambdaExpr>());
      default:
        return compound(expr);
    }
  }

  void compound(const ast::Expr* expr) {
    using K = ast::ExprKind;
    const auto two = [&](std::string_view head, const ast::Expr* a, const ast::Expr* b) {
      add("(", head, " ");
      value(a);
      add(" ");
      value(b);
      add(")");
    };
    if (expr->kind == K::kBinary) {
      const auto& binary = expr->as<ast::BinaryExpr>();
      return two("op" + std::to_string(static_cast<int>(binary.op)), binary.left, binary.right);
    }
    if (expr->kind == K::kUntil)
      return two("until", expr->as<ast::UntilExpr>().motion, expr->as<ast::UntilExpr>().condition);
    add("(");
    if (expr->kind == K::kMember) {
      value(expr->as<ast::MemberExpr>().object);
      add(".", expr->as<ast::MemberExpr>().member.text);
    } else if (expr->kind == K::kUnary) {
      add(std::string(1, "-+!"[static_cast<int>(expr->as<ast::UnaryExpr>().op)]));
      value(expr->as<ast::UnaryExpr>().operand);
    } else if (expr->kind == K::kCast) {
      add("cast ", expr->as<ast::CastExpr>().type.text, " ");
      value(expr->as<ast::CastExpr>().operand);
    } else if (expr->kind == K::kCond) {
      value(expr->as<ast::CondExpr>().condition);
      add(" ? ");
      value(expr->as<ast::CondExpr>().yes);
      add(" : ");
      value(expr->as<ast::CondExpr>().no);
    } else if (expr->kind == K::kCall) {
      value(expr->as<ast::CallExpr>().callee);
      args(expr->as<ast::CallExpr>().args);
    } else if (expr->kind == K::kNewObject) {
      add("new ");
      type(expr->as<ast::NewObjectExpr>().type);
      args(expr->as<ast::NewObjectExpr>().args);
    } else if (expr->kind == K::kIndex) {
      index(expr->as<ast::IndexExpr>());
    } else {
      const auto& array = expr->as<ast::NewArrayExpr>();
      add("new[] ");
      type(array.element);
      values("sizes", array.sizes);
      add(" open ", std::to_string(array.open_dimensions), " ");
      value(array.init);
    }
    add(")");
  }

  void index(const ast::IndexExpr& expr) {
    value(expr.object);
    list(" at", expr.items, [&](const ast::IndexItem& item) {
      value(item.first);
      if (!item.is_range) return;
      add(":");
      value(item.last);
    });
  }

  void formatted(const ast::FormattedExpr& expr) {
    add("(f '", expr.texts[0], "'");
    for (std::size_t i = 0; i < expr.pieces.size(); ++i) {
      const ast::FormatSpec& format = expr.pieces[i].format;
      add(" {");
      value(expr.pieces[i].value);
      add("|", std::to_string(format.style.digits), "|",
          format.style.notation == 0 ? "-" : std::string(1, format.style.notation), "|",
          format.unit, "} '", expr.texts[i + 1], "'");
    }
    add(")");
  }

  void lambda(const ast::LambdaExpr& expr) {
    params("fn", expr.params);
    add("->");
    type(expr.result);
    if (expr.body != nullptr) return statement(expr.body);
    add(" => ");
    value(expr.value);
  }

  void items(ast::Seq<ast::BlockItem> list_of) {
    list("items", list_of, [&](const ast::BlockItem& item) {
      add(item.name.text, item.is_row ? " " : ":", item.constructor.text);
      if (item.is_row) return args(item.args);
      value(item.value);
    });
  }

  // Blanks at the ends of its lines say nothing.
  void doc(std::string_view text) {
    if (text.empty()) return;
    add(" \"");
    std::size_t blanks = 0;
    for (const char c : text) {
      if (c == ' ' || c == '\t') {
        ++blanks;
        continue;
      }
      if (c != '\n') out_.append(blanks, ' ');
      blanks = 0;
      out_ += c;
    }
    add("\"");
  }

  void statements(const char* head, ast::Seq<ast::Stmt*> list_of) {
    list(head, list_of, [&](const ast::Stmt* one) { statement(one); });
  }

  void statement(const ast::Stmt* stmt);
  void declaration(const ast::Stmt* stmt);
  void loop(const ast::Stmt* stmt);
  void robot_statement(const ast::Stmt* stmt);

  std::string out_;
};

void TreeDump::statement(const ast::Stmt* stmt) {
  using K = ast::StmtKind;
  if (stmt == nullptr) return add("none");
  add("<", std::to_string(static_cast<int>(stmt->kind)), " ");
  switch (stmt->kind) {
    case K::kBlock:
      statements("block", static_cast<const ast::Block*>(stmt)->body);
      break;
    case K::kExpr:
      value(stmt->as<ast::ExprStmt>().value);
      break;
    case K::kAssign:
      values("targets", stmt->as<ast::AssignStmt>().targets);
      add(stmt->as<ast::AssignStmt>().compound
              ? " op" + std::to_string(static_cast<int>(stmt->as<ast::AssignStmt>().op))
              : "",
          " = ");
      value(stmt->as<ast::AssignStmt>().value);
      break;
    case K::kStep:
      value(stmt->as<ast::StepStmt>().target);
      add(stmt->as<ast::StepStmt>().up ? "++" : "--");
      break;
    case K::kReturn:
      value(stmt->as<ast::ReturnStmt>().value);
      break;
    case K::kThrow:
      value(stmt->as<ast::ThrowStmt>().value);
      break;
    case K::kIf:
      value(stmt->as<ast::IfStmt>().condition);
      statement(stmt->as<ast::IfStmt>().yes);
      statement(stmt->as<ast::IfStmt>().no);
      break;
    case K::kTry:
      statement(stmt->as<ast::TryStmt>().body);
      list("catches", stmt->as<ast::TryStmt>().catches, [&](const ast::CatchClause& clause) {
        add(clause.name.text);
        statement(clause.body);
      });
      statement(stmt->as<ast::TryStmt>().finally);
      break;
    default:
      declaration(stmt);
  }
  add(">");
}

void TreeDump::declaration(const ast::Stmt* stmt) {
  using K = ast::StmtKind;
  switch (stmt->kind) {
    case K::kVar:
      add(stmt->as<ast::VarStmt>().fixed ? "let" : "var");
      doc(stmt->as<ast::VarStmt>().doc);
      return list("", stmt->as<ast::VarStmt>().declarators, [&](const ast::Declarator& one) {
        add(one.name.text, ":");
        type(one.type);
        add("=");
        value(one.init);
      });
    case K::kObject:
      type(stmt->as<ast::ObjectStmt>().type);
      add(" ", stmt->as<ast::ObjectStmt>().name.text);
      doc(stmt->as<ast::ObjectStmt>().doc);
      return items(stmt->as<ast::ObjectStmt>().items);
    case K::kFunction: {
      const auto& function = stmt->as<ast::FunctionStmt>();
      add(function.name.text);
      doc(function.doc);
      params("", function.params);
      type(function.result);
      return function.body != nullptr ? statement(function.body) : value(function.value);
    }
    case K::kStruct:
      add(stmt->as<ast::StructStmt>().name.text);
      doc(stmt->as<ast::StructStmt>().doc);
      return params("fields", stmt->as<ast::StructStmt>().fields);
    case K::kEnum:
      add(stmt->as<ast::EnumStmt>().name.text);
      doc(stmt->as<ast::EnumStmt>().doc);
      return list("", stmt->as<ast::EnumStmt>().values,
                  [&](const ast::Name& name) { add(name.text); });
    case K::kImport:
      return add(stmt->as<ast::ImportStmt>().path, " as ", stmt->as<ast::ImportStmt>().alias.text);
    case K::kTest:
      add(stmt->as<ast::TestStmt>().name);
      return statement(stmt->as<ast::TestStmt>().body);
    default:
      return loop(stmt);
  }
}

void TreeDump::loop(const ast::Stmt* stmt) {
  using K = ast::StmtKind;
  switch (stmt->kind) {
    case K::kWhile:
      value(stmt->as<ast::WhileStmt>().condition);
      return statement(stmt->as<ast::WhileStmt>().body);
    case K::kDo:
      statement(stmt->as<ast::DoStmt>().body);
      return value(stmt->as<ast::DoStmt>().condition);
    case K::kForIn:
      if (!stmt->as<ast::ForInStmt>().index.text.empty())
        add(stmt->as<ast::ForInStmt>().index.text, ",");
      add(stmt->as<ast::ForInStmt>().name.text, ":");
      type(stmt->as<ast::ForInStmt>().type);
      value(stmt->as<ast::ForInStmt>().items);
      return statement(stmt->as<ast::ForInStmt>().body);
    case K::kFor:
      statements("init", stmt->as<ast::ForStmt>().init);
      value(stmt->as<ast::ForStmt>().condition);
      statements("step", stmt->as<ast::ForStmt>().step);
      return statement(stmt->as<ast::ForStmt>().body);
    case K::kSwitch:
      value(stmt->as<ast::SwitchStmt>().value);
      return list("cases", stmt->as<ast::SwitchStmt>().cases, [&](const ast::SwitchCase& one) {
        values(one.is_default ? "default" : "case", one.values);
        statements("", one.body);
      });
    default:
      return robot_statement(stmt);
  }
}

void TreeDump::robot_statement(const ast::Stmt* stmt) {
  using K = ast::StmtKind;
  switch (stmt->kind) {
    case K::kParallel:
      return statement(stmt->as<ast::ParallelStmt>().body);
    case K::kWhen:
      value(stmt->as<ast::WhenStmt>().condition);
      return statement(stmt->as<ast::WhenStmt>().body);
    case K::kEvery:
      value(stmt->as<ast::EveryStmt>().period);
      return statement(stmt->as<ast::EveryStmt>().body);
    case K::kWith:
      args(stmt->as<ast::WithStmt>().settings);
      return statement(stmt->as<ast::WithStmt>().body);
    case K::kPath:
      args(stmt->as<ast::PathStmt>().settings);
      return statement(stmt->as<ast::PathStmt>().body);
    case K::kRecord:
      add(stmt->as<ast::RecordStmt>().name.text, " ");
      value(stmt->as<ast::RecordStmt>().period);
      return items(stmt->as<ast::RecordStmt>().items);
    case K::kWait:
      return value(stmt->as<ast::WaitStmt>().duration);
    case K::kWaitUntil:
      value(stmt->as<ast::WaitUntilStmt>().condition);
      return args(stmt->as<ast::WaitUntilStmt>().args);
    default:
      return;
  }
}

}  // namespace

std::string dump(const Parsed& parsed) { return TreeDump().program(parsed); }

std::string dump(const std::string& text) {
  SourceSet sources;
  const Source& source = sources.add("test.rbt", text);
  Arena arena;
  DiagnosticSink sink;
  const Parsed parsed = parse(source, arena, sink);
  if (parsed.ok) return dump(parsed);
  std::string messages;
  for (const Diagnostic& message : sink.take_sorted()) messages += render_text(message, sources);
  return messages;
}

TEST_CASE("a dump shows what a program says and not how it is laid out") {
  CHECK(dump("let a = f( b,1 )") == dump("let a =\n    f(b, 1);\n"));
  CHECK(dump("let a = f(b, 1)") != dump("let a = f(b, 2)"));
}

}  // namespace armlet::lang
