#pragma once
// The messages about one file: what is reported, and what has been said.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/source.hpp"
#include "check/scopes/scopes.hpp"
#include "check/state/call.hpp"

namespace armlet::lang {

struct Checker;

// What failed has the type `any`, which fits everywhere, so that one mistake gives one message.
// Statement by statement the sink drops what follows a first message.
class Messages {
 public:
  // most           how many messages there may be.
  // syntax_failed  statements are missing, so unknown names prove nothing.
  Messages(DiagnosticSink& sink, const Scopes& scopes, int most, bool syntax_failed)
      : sink_(sink), scopes_(scopes), most_(most), syntax_failed_(syntax_failed) {}

  // Adds where a generic function was called, and lines that go on with the one above.
  void report(Diagnostic diagnostic);

  void begin_statement() { sink_.begin_statement(); }
  [[nodiscard]] bool statement_failed() const { return sink_.statement_failed(); }
  void set_statement_failed(bool failed) { sink_.set_statement_failed(failed); }
  [[nodiscard]] bool has_errors() const { return sink_.has_errors(); }  // in any file
  // Of this file, with those that were dropped.
  [[nodiscard]] int errors() const { return errors_; }

  // Whether an error, or advice, would be kept now: what is dear to say need not be made otherwise.
  [[nodiscard]] bool takes_errors() const { return !sink_.statement_failed() && !sink_.full(); }
  [[nodiscard]] bool takes_advice() const { return static_cast<int>(sink_.all().size()) < most_; }

  [[nodiscard]] bool syntax_failed() const { return syntax_failed_; }
  void set_syntax_failed() { syntax_failed_ = true; }

  // Whether a name is to be reported for the first time.
  [[nodiscard]] bool is_first(std::string_view name) { return told_.emplace(name).second; }
  // The same for an unknown name, which proves nothing where statements are missing.
  [[nodiscard]] bool is_news(std::string_view name) { return !syntax_failed_ && is_first(name); }
  [[nodiscard]] bool was_told(std::string_view name) const { return told_.contains(name); }
  void forget(std::string_view name) { told_.erase(std::string(name)); }

  // The expression that is checked stands in one whose bracket stands on another line.
  void open(const Joined& joined) { joined_.push_back(joined); }
  void close_joined() { joined_.pop_back(); }

 private:
  DiagnosticSink& sink_;
  const Scopes& scopes_;
  int most_;
  bool syntax_failed_;
  int errors_ = 0;
  std::set<std::string, std::less<>> told_;  // unknown names
  std::vector<Joined> joined_;               // around the expression that is checked
};

[[nodiscard]] std::string line_name(const Checker& checker, Span span);

}  // namespace armlet::lang
