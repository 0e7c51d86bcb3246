#pragma once
// A message about a program: a code, one sentence, marks in the text, a reason, and a fix.
//
// Diagnostics are data. `render` (render.hpp) makes the text of the language reference, section
// 20.1, or one line of JSON. The headlines and the help pages are in the catalogue, messages/*.def.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/messages/message_code.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

enum class Severity : std::uint8_t { kError, kAdvice };

// A marked piece of text with a short label (may be empty).
struct Mark {
  Span span{};
  std::string label{};
};

// A replacement of the text of `span` by `text` (an empty span inserts).
struct Edit {
  Span span{};
  std::string text{};
};

enum class Confidence : std::uint8_t { kMaybe, kSure };

struct Fix {
  std::string text{};
  std::vector<Edit> edits{};
  Confidence confidence = Confidence::kMaybe;
};

// The circumstances of a message at run time.
struct When {
  std::int64_t time_ns = 0;
  std::string resource_type{};       // "motor"; empty if the message is not about a resource
  std::string resource{};            // its name
  std::string task{};                // "branch 2 of parallel on line 9", or empty
  std::optional<bool> moved{};       // whether this command had begun to act
  std::string moved_text{};          // the same in words of the host: "nothing has moved"
  std::string note{};                // "in the 5th pass of the loop on line 7", or empty
  std::vector<std::string> calls{};  // the innermost first: "slot, called on line 12"
};

struct Diagnostic {
  std::string code;  // "E0401"; the first letter is the severity: E and R, or W
  Severity severity = Severity::kError;
  std::string message;        // the headline
  Mark mark;                  // marked with ^
  std::vector<Mark> related;  // marked with -
  std::string why;
  std::optional<Fix> fix;
  std::optional<When> when;
};

// Starts a message about `span`.
[[nodiscard]] Diagnostic make_diagnostic(const Headline& headline, Span span);

// Starts a message from the catalogue: fills the headline's {} in order.
template <std::size_t N>
[[nodiscard]] Diagnostic make_diagnostic(CodeFor<N> code, Span span,
                                         const std::string (&arguments)[N]) {
  return make_diagnostic(Headline(code, arguments), span);
}
[[nodiscard]] inline Diagnostic make_diagnostic(MessageCode<0> code, Span span) {
  return make_diagnostic(Headline(code), span);
}

// Collects messages by the rules of section 20.2: at most one error per statement, and at most
// `limit` messages.
class DiagnosticSink {
 public:
  explicit DiagnosticSink(int limit = 10) : limit_(limit) {}

  // Begins a new statement, in which an error is reported again.
  void begin_statement() { statement_failed_ = false; }
  void set_statement_failed(bool failed) { statement_failed_ = failed; }
  [[nodiscard]] bool statement_failed() const { return statement_failed_; }

  // Returns false if the message was dropped.
  bool report(Diagnostic diagnostic);

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] bool full() const { return errors_ >= limit_; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  // The messages in the order of the text, errors and advice together. They are moved out.
  [[nodiscard]] std::vector<Diagnostic> take_sorted();

 private:
  int limit_;
  int errors_ = 0;
  bool statement_failed_ = false;
  std::vector<Diagnostic> all_;
};

}  // namespace armlet
