#pragma once
// The only entrance to the parser.

#include <atomic>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "ast/ast.hpp"
#include "base/arena.hpp"
#include "syntax/read_before.hpp"
#include "syntax/tokens/shape.hpp"

namespace armlet::lang {

struct Parsed {
  std::vector<ast::Stmt*> statements;  // only those without a mistake
  std::vector<Span> comments;          // with their marks, in the order of the text
  bool ok = false;                     // nothing but advice was reported
};

// Reads a program. The tree lives in `arena` and refers to the text of `source`; both must outlive
// it. Text of any kind ends with a tree or with messages in `sink`, after a time in proportion to
// its length. Safe to call from any thread; ANTLR's caches are shared, so calls wait for each
// other. If `shape` is given, it is filled too; it is whole if the result is ok. Throws Cancelled
// soon after `cancelled` has become true.
[[nodiscard]] Parsed parse(const Source& source, Arena& arena, DiagnosticSink& sink,
                           const ParseLimits& limits = {}, Shape* shape = nullptr,
                           const std::atomic<bool>* cancelled = nullptr);

// The same, and what the text most likely becomes when it is written to its end.
struct Mended {
  bool is_readable = true;  // false: brackets or tokens are wrong, and `exact` is empty
  Parsed exact{};           // what parse gives
  std::vector<ast::Stmt*> statements{};  // also those with a mistake, with what is missing put in
  Tokens tokens{};                       // of the text, as far as it could be divided into tokens
  std::vector<Span> comments{};
  std::vector<ReadStatement> read{};  // those that need not be read again, for ReadBefore
};
// A name without text stands where a name, a value or a type is missing. Statements without a
// mistake are in both lists. Those in `before` are copied rather than read.
[[nodiscard]] Mended parse_and_mend(const Source& source, Arena& arena, DiagnosticSink& sink,
                                    const ParseLimits& limits = {},
                                    const std::atomic<bool>* cancelled = nullptr,
                                    const ReadBefore* before = nullptr);

// Whether the prompt should read the text now, or wait for more lines: a bracket is open, or the
// last line goes on.
[[nodiscard]] bool is_complete(const Source& source, const ParseLimits& limits = {});
// Whether the statement that stands before the byte goes on behind it.
[[nodiscard]] bool goes_on(const Source& source, std::uint32_t byte,
                           const ParseLimits& limits = {});

}  // namespace armlet::lang
