#pragma once
// The public functions of the parser.

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
  bool ok = false;                     // nothing apart from advice was reported
};

// Parses a program. The tree is made in `arena` and refers to the text of `source`; both must
// outlive it. Any text results in a tree or in messages in `sink`, in a time proportional to its
// length. May be called from any thread; the caches of ANTLR are shared, so that calls may wait for
// each other. If `shape` is given, it is filled too; it is complete if the result is ok. Throws
// Cancelled soon after `cancelled` has become true.
[[nodiscard]] Parsed parse(const Source& source, Arena& arena, DiagnosticSink& sink,
                           const ParseLimits& limits = {}, Shape* shape = nullptr,
                           const std::atomic<bool>* cancelled = nullptr);

// The tree of a text, and the tree that the text most likely has when it is completed.
struct Mended {
  bool is_readable = true;  // false: brackets or tokens are invalid, and `exact` is empty
  Parsed exact{};           // the result of `parse`
  // Also those with a mistake, with their missing parts inserted.
  std::vector<ast::Stmt*> statements{};
  Tokens tokens{};  // of the text, as far as it consists of valid tokens
  std::vector<Span> comments{};
  std::vector<ReadStatement> read{};  // that need not be parsed again; for ReadBefore
};
// Parses a text and repairs its mistakes. A missing name, value or type is a name with an empty
// text. Statements without a mistake are in both lists. Those that ReadBefore finds are copied and
// not parsed.
[[nodiscard]] Mended parse_and_mend(const Source& source, Arena& arena, DiagnosticSink& sink,
                                    const ParseLimits& limits = {},
                                    const std::atomic<bool>* cancelled = nullptr,
                                    const ReadBefore* before = nullptr);

// Whether the prompt should execute the text now. False: it should wait for more lines, because a
// bracket is open or the last line is incomplete.
[[nodiscard]] bool is_complete(const Source& source, const ParseLimits& limits = {});
// Whether the statement before the byte continues after it.
[[nodiscard]] bool goes_on(const Source& source, std::uint32_t byte,
                           const ParseLimits& limits = {});

}  // namespace armlet::lang
