#pragma once
// The messages about one file, and the names that were reported already.

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

// A value that failed has the type `any`, which fits everywhere, so that one mistake causes one
// message. In each statement the sink drops the messages after the first error.
class Messages {
 public:
  // most           the limit of messages.
  // syntax_failed  statements are missing from the tree, so unknown names may be declared in them.
  Messages(DiagnosticSink& sink, const Scopes& scopes, int most, bool syntax_failed)
      : sink_(sink), scopes_(scopes), most_(most), syntax_failed_(syntax_failed) {}

  // Reports a message. Adds the call of a generic function, and lines that continue the one above.
  void report(Diagnostic diagnostic);

  void begin_statement() { sink_.begin_statement(); }
  [[nodiscard]] bool statement_failed() const { return sink_.statement_failed(); }
  void set_statement_failed(bool failed) { sink_.set_statement_failed(failed); }
  [[nodiscard]] bool has_errors() const { return sink_.has_errors(); }  // in any file
  // The count of errors of this file, with those that were dropped.
  [[nodiscard]] int errors() const { return errors_; }

  // Whether an error would be kept now; if not, the text of the message need not be made.
  [[nodiscard]] bool takes_errors() const { return !sink_.statement_failed() && !sink_.full(); }
  [[nodiscard]] bool takes_advice() const { return static_cast<int>(sink_.all().size()) < most_; }

  [[nodiscard]] bool syntax_failed() const { return syntax_failed_; }
  void set_syntax_failed() { syntax_failed_ = true; }

  // Whether a name has not been reported before.
  [[nodiscard]] bool is_first(std::string_view name) { return told_.emplace(name).second; }
  // Whether to report an unknown name: not if statements are missing from the tree, nor a second
  // time.
  [[nodiscard]] bool is_news(std::string_view name) { return !syntax_failed_ && is_first(name); }
  [[nodiscard]] bool was_told(std::string_view name) const { return told_.contains(name); }
  void forget(std::string_view name) { told_.erase(std::string(name)); }

  // The current expression is part of one whose bracket is on another line.
  void open(const Joined& joined) { joined_.push_back(joined); }
  void close_joined() { joined_.pop_back(); }

 private:
  DiagnosticSink& sink_;
  const Scopes& scopes_;
  int most_;
  bool syntax_failed_;
  int errors_ = 0;
  std::set<std::string, std::less<>> told_;  // unknown names that were reported
  std::vector<Joined> joined_;               // around the current expression
};

[[nodiscard]] std::string line_name(const Checker& checker, Span span);

}  // namespace armlet::lang
