#include "syntax/parse.hpp"

#include <chrono>
#include <mutex>

#include "compile/cancelled.hpp"
#include "syntax/build/build_ast.hpp"
#include "syntax/mistakes/brackets.hpp"
#include "syntax/mistakes/recovery.hpp"
#include "syntax/mistakes/syntax_errors.hpp"
#include "syntax/table_prediction.hpp"
#include "syntax/token_feed.hpp"
#include "syntax/tokens/lex.hpp"
#include "syntax/tokens/line_ends.hpp"

namespace armlet::lang {
namespace {

// Levels of the tree. Every later stage may recurse this deep; a chain of operators is as deep as
// it is long.
constexpr std::size_t kMaxDepth = 1000;

std::timed_mutex& parser_mutex() {
  static std::timed_mutex mutex;
  return mutex;
}

std::unique_lock<std::timed_mutex> lock_parser(const std::atomic<bool>* cancelled) {
  std::unique_lock lock(parser_mutex(), std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(10))) stop_if(cancelled);
  return lock;
}

// One text, or the value inside a formatted text.
class Front {
 public:
  Front(const Source& source, Arena& arena, DiagnosticSink& sink, const ParseLimits& limits,
        Shape* shape = nullptr, const std::atomic<bool>* cancelled = nullptr)
      : source_(source),
        arena_(arena),
        sink_(sink),
        limits_(limits),
        shape_(shape),
        cancelled_(cancelled) {}

  Parsed program() {
    Parsed out;
    if (!check_text(source_, sink_, limits_) || !read(program_range(source_))) return out;
    tokens_ = insert_line_ends(tokens_);
    out.statements = statements();
    if (shape_ != nullptr) {
      shape_->tokens = std::move(tokens_);
      shape_->comments = comments_;
    }
    out.comments = std::move(comments_);
    out.ok = ok_;
    return out;
  }

  ast::Expr* piece(Span range, std::size_t depth) {
    if (!read(range)) return nullptr;
    Machine machine(*this);
    const BuildInput input = build_input(depth);
    AstBuilder builder(input);
    ast::Expr* value = nullptr;
    try {
      RbtParser::ExpressionContext* ctx = machine.parser.expression();
      if (machine.feed.LA(1) != antlr4::Token::EOF) {
        const Token& at = tokens_[machine.feed.index()];
        const Span span{at.begin, at.end, source_.id()};
        ok_ = false;
        sink_.report(make_diagnostic("E0128", span, {std::string(source_.slice(span))}));
      } else {
        value = builder.expression(ctx);
      }
    } catch (const antlr4::RecognitionException&) {  // reported by the recovery
    } catch (const antlr4::ParseCancellationException&) {
      report_guard(machine);
    }
    return ok_ && !builder.failed() ? value : nullptr;
  }

 private:
  // ANTLR's objects for one run over the tokens.
  struct Machine {
    explicit Machine(Front& front) : feed(front.tokens_, front.cancelled_), parser(&feed) {
      parser.removeErrorListeners();
      parser.setErrorHandler(std::make_shared<StatementRecovery>(
          front.tokens_, [&front](std::size_t statement, std::size_t at) {
            return front.report_failure(statement, at);
          }));
      using Prediction = antlr4::atn::ParserATNSimulator;
      auto tables =
          std::make_unique<TablePrediction>(&parser, *parser.getInterpreter<Prediction>());
      // The grammar never needs more: a test looks for full-context decisions in random programs.
      tables->setPredictionMode(antlr4::atn::PredictionMode::SLL);
      parser.setInterpreter(tables.release());
      parser.max_level = front.limits_.nesting;
      parser.max_chain = kMaxDepth;
    }
    TokenFeed feed;
    RbtParser parser;
  };

  bool read(Span range) {
    Lexed lexed = lex(source_, range, sink_, limits_, cancelled_);
    tokens_ = std::move(lexed.tokens);
    comments_ = std::move(lexed.comments);
    if (!lexed.ok) return false;
    std::optional<Diagnostic> bracket = check_brackets(source_, tokens_);
    if (!bracket) return true;
    sink_.begin_statement();
    sink_.report(std::move(*bracket));
    return false;
  }

  BuildInput build_input(std::size_t depth) {
    return {source_,
            tokens_,
            comments_,
            arena_,
            sink_,
            kMaxDepth,
            depth,
            [this](Span range, std::size_t at) {
              return Front(source_, arena_, sink_, limits_, nullptr, cancelled_).piece(range, at);
            },
            cancelled_};
  }

  // Statement by statement, so that memory goes with the longest one and not with the text.
  std::vector<ast::Stmt*> statements() {
    std::vector<ast::Stmt*> out;
    Machine machine(*this);
    const BuildInput input = build_input(0);
    AstBuilder builder(input);
    try {
      while (machine.feed.LA(1) != antlr4::Token::EOF && !sink_.full()) {
        machine.feed.drop_past();
        const std::size_t first = machine.feed.index();
        statement_ok_ = true;
        RbtParser::StmtContext* ctx = machine.parser.stmt();
        if (machine.feed.index() == first) machine.feed.consume();
        ast::Stmt* made = statement_ok_ ? builder.statement(ctx) : nullptr;
        if (builder.take_incomplete()) made = nullptr;
        if (shape_ != nullptr && statement_ok_) shape_->program.parts.push_back(shape_of(ctx));
        if (made != nullptr) out.push_back(made);
        machine.parser.getTreeTracker().reset();
      }
    } catch (const antlr4::ParseCancellationException&) {
      report_guard(machine);
    } catch (const TreeTooDeep& deep) {
      report_depth({deep.span.begin, deep.span.begin + 1, deep.span.source}, kMaxDepth,
                   " operations");
    }
    ok_ = ok_ && !builder.failed();
    return out;
  }

  std::size_t report_failure(std::size_t statement, std::size_t at) {
    ok_ = false;
    statement_ok_ = false;
    sink_.begin_statement();
    sink_.report(explain_failure(source_, tokens_, statement, at));
    return end_of_python_function(source_, tokens_, statement, at);
  }

  void report_depth(Span span, std::size_t limit, const char* what) {
    ok_ = false;
    sink_.begin_statement();
    sink_.report(make_diagnostic("E0125", span, {std::to_string(limit) + what}));
  }

  // The parser stopped at a guard: of nesting, or of the length of a chain.
  void report_guard(Machine& machine) {
    const Token& at = tokens_[machine.feed.index()];
    const Span span{at.begin, at.end, source_.id()};
    if (machine.parser.chain_too_long) return report_depth(span, kMaxDepth, " operations");
    report_depth(span, limits_.nesting, " levels");
  }

  const Source& source_;
  Arena& arena_;
  DiagnosticSink& sink_;
  const ParseLimits& limits_;
  Shape* shape_;
  const std::atomic<bool>* cancelled_;
  Tokens tokens_;
  std::vector<Span> comments_;
  bool ok_ = true;
  bool statement_ok_ = true;
};

}  // namespace

Parsed parse(const Source& source, Arena& arena, DiagnosticSink& sink, const ParseLimits& limits,
             Shape* shape, const std::atomic<bool>* cancelled) {
  const std::unique_lock lock = lock_parser(cancelled);
  return Front(source, arena, sink, limits, shape, cancelled).program();
}

bool is_complete(const Source& source, const ParseLimits& limits) {
  const std::unique_lock lock = lock_parser(nullptr);
  DiagnosticSink sink;
  if (!check_text(source, sink, limits)) return true;
  const Lexed lexed = lex(source, program_range(source), sink, limits);
  return !lexed.ok || could_end_here(lexed.tokens);
}

}  // namespace armlet::lang
