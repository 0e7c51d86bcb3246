#pragma once
// Text to tokens. What is no token is reported here, in the words of the program.

#include <atomic>
#include <string_view>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

struct Lexed {
  Tokens tokens;               // without comments and line breaks
  std::vector<Span> comments;  // in order, with their marks
  bool ok = true;              // false: something was reported
};

// Whether the whole text is what a program may be: not too long, UTF-8, no control characters.
// Reports otherwise.
[[nodiscard]] bool check_text(const Source& source, DiagnosticSink& sink,
                              const ParseLimits& limits);

// The tokens of the part `range` of a text that check_text accepted. Stops at brackets nested
// deeper than the limit. Throws Cancelled soon after `cancelled` has become true.
[[nodiscard]] Lexed lex(const Source& source, Span range, DiagnosticSink& sink,
                        const ParseLimits& limits, const std::atomic<bool>* cancelled = nullptr);

// Whether a text is one word that programs can give to something: a name of the grammar.
[[nodiscard]] bool is_name(std::string_view text);
// Whether an argument can be called so: names, and `every` and `when`, which are words of
// statements elsewhere.
[[nodiscard]] bool is_argument_name(std::string_view text);

// The part of a text that holds the program: without a byte-order mark and a first line that starts
// with #!.
[[nodiscard]] Span program_range(const Source& source);

}  // namespace armlet::lang
