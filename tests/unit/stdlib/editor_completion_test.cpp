// Every example cut off at every token: the analysis always answers, and what comes next is
// offered.

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>

#include "editor/facts.hpp"
#include "editor_support.hpp"
#include "syntax/tokens/token_kinds.hpp"

using namespace armlet;
using namespace armlet::editor_test;

namespace {

// Whether the whole text shows that the name at a token is one that can be offered: it refers to
// something declared elsewhere, or belongs to the library.
bool can_be_offered(const lang::Facts& whole, const lang::Token& token) {
  const lang::Reference* reference = whole.reference_at(token.begin);
  if (reference != nullptr && reference->name.begin == token.begin) {
    const lang::Symbol& symbol = whole.names.symbols[reference->symbol];
    const bool is_declaration = symbol.declared == reference->name;
    // A function or type may be declared further down, which is not there yet.
    return !is_declaration && (symbol.declared.source != 0 || symbol.declared.begin < token.begin);
  }
  const auto* native = whole.native_at(token.begin);
  return native != nullptr && native->name.begin == token.begin;
}

}  // namespace

TEST_CASE("at every cut of every example what was written next is offered") {
  int asked = 0;
  int offered = 0;
  for (const auto& path : programs_below("examples")) {
    const std::string text = read(path);
    Session session(library_engine(), options_for(path));
    const auto whole = session.analyse(text, path.filename().string());
    for (const lang::Token& token : tokens_of(text)) {
      const auto cut = session.analyse(text.substr(0, token.begin), path.filename().string());
      const Completions list = cut->completion(token.begin);
      CHECK(list.replaced.end <= token.begin);
      (void)cut->hover(token.begin);
      (void)cut->signature_help(token.begin);
      (void)cut->inlay_hints();
      if (!lang::is_name(token.type) || !can_be_offered(whole->facts(), token)) continue;
      ++asked;
      const std::string word = text.substr(token.begin, token.end - token.begin);
      const bool found = offers(list, word);
      offered += found ? 1 : 0;
      if (!found && std::getenv("ARMLET_SHOW_MISSES") != nullptr) {
        const Position at = whole->sources().position({token.begin, token.end, 0});
        std::fprintf(stderr, "%s:%d:%d %s\n", path.filename().c_str(), at.line, at.column,
                     word.c_str());
      }
    }
  }
  MESSAGE("offered " << offered << " of " << asked);
  CHECK(asked > 1000);
  CHECK(offered >= asked * 98 / 100);
}
