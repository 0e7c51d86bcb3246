#include "syntax/parse.hpp"

#include <algorithm>

#include "ast/ast_copy.hpp"
#include "base/cancelled.hpp"
#include "base/quotes.hpp"
#include "syntax/build/build_ast.hpp"
#include "syntax/mistakes/brackets.hpp"
#include "syntax/mistakes/recovery.hpp"
#include "syntax/mistakes/syntax_errors.hpp"
#include "syntax/parser/table_prediction.hpp"
#include "syntax/parser/token_feed.hpp"
#include "syntax/repair/balance.hpp"
#include "syntax/repair/first_failure.hpp"
#include "syntax/repair/mend.hpp"
#include "syntax/tokens/lex.hpp"
#include "syntax/tokens/line_ends.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

// The largest depth of the tree. Later stages may use recursion up to this depth; a chain of
// operators is as deep as its length.
constexpr std::size_t kMaxDepth = 1000;

// The limit of messages about a text that is repaired; no statement after it is kept for the next
// parse.
constexpr int kMostQuietMessages = 100;

// The limit of statements at the top level that are repaired, since each repair parses several
// times.
constexpr int kMostMended = 50;

// Parses one text, or the value inside a formatted text.
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
    if (!check_text(source_, sink_, limits_)) return out;
    if (!read(program_range(source_))) {
      if (unreadable_.empty()) return out;
      read_around_errors();
    }
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

  Mended mended_program(const ReadBefore* before) {
    Mended out;
    mended_ = &out.statements;
    read_ = &out.read;
    before_ = before;
    out.is_readable = check_text(source_, sink_, limits_);
    if (!out.is_readable) return out;
    out.is_readable = read(program_range(source_));
    out.tokens = tokens_;
    out.comments = comments_;
    if (out.is_readable) {
      tokens_ = insert_line_ends(tokens_);
      out.exact.statements = statements();
      out.exact.comments = comments_;
      out.exact.ok = ok_;
    } else {
      mend_all(std::move(tokens_));
    }
    return out;
  }

  ast::Expr* piece(Span range, std::size_t depth) { return read(range) ? value(depth) : nullptr; }

  // The value with its missing parts inserted; null if the repair fails.
  ast::Expr* mended_piece(Span range, std::size_t depth) {
    (void)read(range);
    Tokens tokens = balanced(source_, without_errors(std::move(tokens_)));
    Token& end = tokens.back();
    tokens.insert(tokens.end() - 1, {.begin = end.begin, .end = end.begin, .type = RbtLexer::SEMI});
    std::optional<Tokens> whole =
        mended(std::move(tokens), [this](const Tokens& trial) { return failure_of(trial); });
    if (!whole || whole->size() < 2) return nullptr;
    completed_ = std::ranges::any_of(*whole, &Token::inserted);
    tokens_ = *std::move(whole);
    tokens_.erase(tokens_.end() - 2);
    return value(depth);
  }

 private:
  ast::Expr* value(std::size_t depth) {
    Machine machine = make_machine();
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

  // The objects of ANTLR for one pass over the tokens.
  struct Machine {
    Machine(const Tokens& tokens, std::shared_ptr<antlr4::ANTLRErrorStrategy> at_mistakes,
            const ParseLimits& limits, const std::atomic<bool>* cancelled)
        : feed(tokens, cancelled), parser(&feed) {
      parser.removeErrorListeners();
      parser.setErrorHandler(std::move(at_mistakes));
      using Prediction = antlr4::atn::ParserATNSimulator;
      auto tables =
          std::make_unique<TablePrediction>(&parser, *parser.getInterpreter<Prediction>());
      // The grammar needs no more than SLL prediction: a test searches for full-context decisions
      // in random programs.
      tables->setPredictionMode(antlr4::atn::PredictionMode::SLL);
      parser.setInterpreter(tables.release());
      parser.max_level = limits.nesting;
      parser.max_chain = kMaxDepth;
    }
    TokenFeed feed;
    RbtParser parser;
  };

  Machine make_machine() {
    return Machine(tokens_,
                   std::make_shared<StatementRecovery>(
                       tokens_, [this](std::size_t statement,
                                       std::size_t at) { return report_failure(statement, at); }),
                   limits_, cancelled_);
  }

  bool read(Span range) {
    Lexed lexed = lex(source_, range, sink_, limits_, cancelled_);
    tokens_ = std::move(lexed.tokens);
    comments_ = std::move(lexed.comments);
    if (!lexed.ok) {
      for (const Token& token : tokens_) {
        if (is_error(token)) unreadable_.push_back({token.begin, token.end, source_.id()});
      }
      return false;
    }
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
              Front inner(source_, arena_, sink_, limits_, nullptr, cancelled_);
              if (!mending_) return inner.piece(range, at);
              ast::Expr* value = inner.mended_piece(range, at);
              completed_ = completed_ || inner.completed_;
              return value;
            },
            cancelled_};
  }

  // Parses statement by statement, so that the memory depends on the longest statement and not on
  // the length of the text.
  std::vector<ast::Stmt*> statements() {
    std::vector<ast::Stmt*> out;
    Machine machine = make_machine();
    const BuildInput input = build_input(0);
    AstBuilder builder(input);
    try {
      while (machine.feed.LA(1) != antlr4::Token::EOF && (mended_ != nullptr || !sink_.full())) {
        const bool is_wanted = !sink_.full();
        machine.feed.drop_past();
        const std::size_t first = machine.feed.index();
        if (const ReadBefore::Found known = read_before(first); known.statement != nullptr) {
          if (ast::Stmt* made = take(known)) {
            mended_->push_back(made);
            if (is_wanted) out.push_back(made);
          }
          machine.feed.seek(behind(first, read_->back().end));
          continue;
        }
        const std::size_t messages = sink_.all().size();
        statement_ok_ = true;
        completed_ = false;
        RbtParser::StmtContext* ctx = machine.parser.stmt();
        if (machine.feed.index() == first) machine.feed.consume();
        ast::Stmt* made = statement_ok_ ? builder.statement(ctx) : nullptr;
        const bool incomplete = builder.take_incomplete();
        if (incomplete) made = nullptr;
        if (shape_ != nullptr && statement_ok_) shape_->program.parts.push_back(shape_of(ctx));
        if (made != nullptr && is_wanted) out.push_back(made);
        if (mended_ != nullptr && made != nullptr) mended_->push_back(made);
        const bool is_good = is_wanted && statement_ok_ && !incomplete && !completed_ &&
                             sink_.all().size() == messages;
        if (read_ != nullptr && is_good) note_read(made, first, machine.feed.index());
        // A statement that can be parsed but not built has a mistake in a formatted text.
        if (mended_ != nullptr && (!statement_ok_ || incomplete) && mends_left_ > 0) {
          --mends_left_;
          mend(first, machine.feed.index());
        }
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

  [[nodiscard]] ReadBefore::Found read_before(std::size_t first) const {
    if (before_ == nullptr || read_ == nullptr) return {};
    const ReadBefore::Found found = before_->at(tokens_[first].begin);
    if (found.statement == nullptr) return {};
    const auto end = static_cast<std::uint32_t>(found.statement->end + found.shift);
    return form_of(first, end) == found.statement->form ? found : ReadBefore::Found{};
  }

  // A hash of the tokens that the parser sees of a statement between a token and a byte. The bytes
  // alone are not sufficient: an open or superfluous bracket elsewhere changes which ends of
  // statements and which brackets are inserted or omitted here.
  [[nodiscard]] std::uint64_t form_of(std::size_t first, std::uint32_t end) const {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, over numbers in place of bytes
    const auto add = [&hash](std::uint64_t number) { hash = (hash ^ number) * 0x100000001b3; };
    const std::size_t last = behind(first, end);
    for (std::size_t i = first; i < last; ++i) {
      const Token& token = tokens_[i];
      add(token.begin - tokens_[first].begin);
      add(token.type);
      add(token.inserted ? 1 : 0);
    }
    add(tokens_[last].type);
    return hash;
  }

  // A copy of the statement for its new position; null if it is empty.
  ast::Stmt* take(const ReadBefore::Found& known) {
    const ReadStatement& old = *known.statement;
    ast::Stmt* made =
        old.tree != nullptr ? copied(*old.tree, arena_, source_, known.shift) : nullptr;
    read_->push_back({made, static_cast<std::uint32_t>(old.begin + known.shift),
                      static_cast<std::uint32_t>(old.end + known.shift), old.form});
    return made;
  }

  // The first token after a statement that ends at a byte and after the inserted end of the
  // statement.
  [[nodiscard]] std::size_t behind(std::size_t first, std::uint32_t end) const {
    std::size_t at = first;
    while (tokens_[at].type != kEndOfText &&
           (tokens_[at].begin < end || (tokens_[at].inserted && tokens_[at].end <= end)))
      ++at;
    return at;
  }

  void note_read(const ast::Stmt* made, std::size_t first, std::size_t last) {
    std::uint32_t end = tokens_[first].end;
    for (std::size_t i = first; i < last; ++i) {
      if (!tokens_[i].inserted) end = tokens_[i].end;
      // Inserted tokens other than `;` depend on the text around, so the statement cannot be copied
      // later.
      if (tokens_[i].inserted && tokens_[i].type != RbtLexer::SEMI) return;
    }
    if (!tokens_[first].inserted)
      read_->push_back({made, tokens_[first].begin, end, form_of(first, end)});
  }

  // Builds as much as possible from the tokens of one top-level statement with a mistake.
  void mend(std::size_t first, std::size_t last) {
    Tokens statement(tokens_.begin() + static_cast<std::ptrdiff_t>(first),
                     tokens_.begin() + static_cast<std::ptrdiff_t>(last));
    const std::uint32_t end = statement.empty() ? 0 : statement.back().end;
    statement.push_back({.begin = end, .end = end, .type = kEndOfText, .line_break_before = true});
    std::optional<Tokens> whole =
        mended(std::move(statement), [this](const Tokens& tokens) { return failure_of(tokens); });
    if (!whole) return;
    read_quietly(*std::move(whole), false);
  }

  // Builds as much as possible from a text with invalid tokens or with brackets that do not match.
  void mend_all(Tokens tokens) {
    read_quietly(insert_line_ends(balanced(source_, without_errors(std::move(tokens)))), true);
  }

  // mends: whether statements with missing parts are repaired.
  void read_quietly(Tokens tokens, bool mends) {
    DiagnosticSink quiet(kMostQuietMessages);
    Front front(source_, arena_, quiet, limits_, nullptr, cancelled_);
    if (mends) {
      front.read_ = read_;
      front.before_ = before_;
    }
    front.tokens_ = std::move(tokens);
    front.comments_ = comments_;
    front.mended_ = mended_;
    front.mending_ = true;
    if (!mends) front.mends_left_ = 0;
    (void)front.statements();
  }

  // Invalid tokens have been reported. Statements without invalid tokens are parsed as usual.
  void read_around_errors() {
    ok_ = false;
    tokens_ = balanced(source_, without_errors(std::move(tokens_)));
  }

  static bool is_error(const Token& token) {
    return token.type == RbtLexer::BADSTR || token.type == RbtLexer::BADNUM ||
           token.type == RbtLexer::ERR;
  }

  // Whether an invalid token is on one of the lines of a statement, from its first token to
  // another.
  [[nodiscard]] bool is_near_error(std::size_t statement, std::size_t at) const {
    const int first = source_.position(tokens_[statement].begin).line;
    const int last = source_.position(tokens_[std::min(at, tokens_.size() - 1)].end).line;
    return std::ranges::any_of(unreadable_, [&](Span span) {
      const int line = source_.position(span.begin).line;
      return line >= first && line <= last;
    });
  }

  static Tokens without_errors(Tokens tokens) {
    for (Token& token : tokens) {
      // An undeclared name stands for the invalid token: it fails without a second message where a
      // value is expected.
      if (token.type == RbtLexer::BADSTR || token.type == RbtLexer::BADNUM)
        token.type = RbtLexer::ID;
    }
    std::erase_if(tokens, [](const Token& token) { return token.type == RbtLexer::ERR; });
    return tokens;
  }

  std::optional<ParseFailure> failure_of(const Tokens& tokens) {
    const auto failure = std::make_shared<FirstFailure>();
    Machine machine(tokens, failure, limits_, cancelled_);
    try {
      while (machine.feed.LA(1) != antlr4::Token::EOF) {
        const std::size_t first = machine.feed.index();
        machine.parser.stmt();
        machine.parser.getTreeTracker().reset();
        if (machine.feed.index() == first) return ParseFailure{first, first};
      }
    } catch (const antlr4::RecognitionException&) {
      return failure->found();
    } catch (const antlr4::ParseCancellationException&) {
      return ParseFailure{0, machine.feed.index()};
    }
    return std::nullopt;
  }

  std::size_t report_failure(std::size_t statement, std::size_t at) {
    ok_ = false;
    statement_ok_ = false;
    if (!unreadable_.empty() && is_near_error(statement, at)) return 0;
    sink_.begin_statement();
    sink_.report(explain_failure(source_, tokens_, statement, at));
    return std::max(end_of_python_function(source_, tokens_, statement, at),
                    end_of_foreign_loop(source_, tokens_, statement, at));
  }

  void report_depth(Span span, std::size_t limit, const char* what) {
    ok_ = false;
    sink_.begin_statement();
    sink_.report(make_diagnostic("E0125", span, {std::to_string(limit) + what}));
  }

  // The parser stopped at a limit: of nesting, or of the length of a chain.
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
  std::vector<ast::Stmt*>* mended_ = nullptr;   // if set: also for statements with a mistake
  std::vector<ReadStatement>* read_ = nullptr;  // if set: the statements without a message
  const ReadBefore* before_ = nullptr;
  bool mending_ = false;  // a repair: no message is reported
  int mends_left_ = kMostMended;
  Tokens tokens_;
  std::vector<Span> comments_;
  std::vector<Span> unreadable_;  // invalid tokens
  bool ok_ = true;
  bool statement_ok_ = true;
  bool completed_ = false;  // a part was inserted into a formatted text of the current statement
};

}  // namespace

Parsed parse(const Source& source, Arena& arena, DiagnosticSink& sink, const ParseLimits& limits,
             Shape* shape, const std::atomic<bool>* cancelled) {
  return Front(source, arena, sink, limits, shape, cancelled).program();
}

Mended parse_and_mend(const Source& source, Arena& arena, DiagnosticSink& sink,
                      const ParseLimits& limits, const std::atomic<bool>* cancelled,
                      const ReadBefore* before) {
  return Front(source, arena, sink, limits, nullptr, cancelled).mended_program(before);
}

namespace {

// Whether a text over several lines is not closed yet; it is then the last token.
bool holds_open_text(const Source& source, const Tokens& tokens) {
  if (tokens.size() < 2 || tokens[tokens.size() - 2].type != RbtLexer::BADSTR) return false;
  const Token& last = tokens[tokens.size() - 2];
  return quotes_of(source.slice({last.begin, last.end, source.id()})).spans_lines;
}

}  // namespace

bool is_complete(const Source& source, const ParseLimits& limits) {
  DiagnosticSink sink;
  if (!check_text(source, sink, limits)) return true;
  const Lexed lexed = lex(source, program_range(source), sink, limits);
  return !holds_open_text(source, lexed.tokens) && (!lexed.ok || could_end_here(lexed.tokens));
}

bool goes_on(const Source& source, std::uint32_t byte, const ParseLimits& limits) {
  DiagnosticSink sink;
  if (!check_text(source, sink, limits)) return false;
  const Lexed lexed = lex(source, program_range(source), sink, limits);
  return lexed.ok && !ends_before(lexed.tokens, byte);
}

}  // namespace armlet::lang
