#pragma once
// Divides text into tokens, and reports invalid tokens in the words of the program.

#include <atomic>
#include <string_view>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

struct Lexed {
  Tokens tokens;               // without comments and line breaks
  std::vector<Span> comments;  // in the order of the text, with their marks
  bool ok = true;              // false: a message was reported
};

// Whether the text may be a program: not too long, valid UTF-8, no control characters. Reports a
// message otherwise.
[[nodiscard]] bool check_text(const Source& source, DiagnosticSink& sink,
                              const ParseLimits& limits);

// The tokens of the part `range` of a text that check_text accepted. Ends at brackets that are
// nested deeper than the limit. Throws Cancelled soon after `cancelled` has become true.
[[nodiscard]] Lexed lex(const Source& source, Span range, DiagnosticSink& sink,
                        const ParseLimits& limits, const std::atomic<bool>* cancelled = nullptr);

// Whether a text is a valid name of a variable or function.
[[nodiscard]] bool is_name(std::string_view text);
// Whether a text is a valid name of an argument: a name, or `every` or `when`, which are keywords
// of statements elsewhere.
[[nodiscard]] bool is_argument_name(std::string_view text);

// The part of a text with the program: without a byte-order mark and a first line that starts with
// #!.
[[nodiscard]] Span program_range(const Source& source);

}  // namespace armlet::lang
