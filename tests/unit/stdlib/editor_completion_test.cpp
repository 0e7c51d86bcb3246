// Every example cut off at every token: the analysis always answers, and what comes next is
// offered.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "editor/facts.hpp"
#include "editor/symbol_at.hpp"
#include "editor_support.hpp"
#include "syntax/tokens/signs.hpp"
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

void show_miss(const Analysis& whole, const lang::Token& token, const std::string& what) {
  if (std::getenv("ARMLET_SHOW_MISSES") == nullptr) return;
  const Position at = whole.sources().position({token.begin, token.end, 0});
  std::fprintf(stderr, "%s:%d:%d %s\n", whole.facts().main().name().c_str(), at.line, at.column,
               what.c_str());
}

// How often help right behind `(` and `,` is the same in a text that ends there.
struct HelpCount {
  int asked = 0;
  int same = 0;
  int wants_place = 0;  // among the parameters
  int has_place = 0;

  void count(const Analysis& whole, const Analysis& cut, const lang::Token& token) {
    if (token.type != lang::sign::kOpenParenthesis && token.type != lang::sign::kComma) return;
    const auto expected = whole.signature_help(token.end);
    if (!expected) return;
    ++asked;
    const auto found = cut.signature_help(token.end);
    const auto texts = [](const SignatureHelp& help) {
      std::string all;
      for (const auto& overload : help.overloads) all += overload.text + '\n';
      return all;
    };
    const bool is_same = found && texts(*found) == texts(*expected);
    same += is_same ? 1 : 0;
    if (!is_same)
      show_miss(whole, token, "help: " + texts(*expected) + (found ? "but " + texts(*found) : ""));
    // The value that comes next may be a setting.
    if (!is_same || expected->parameter < 0) return;
    has_place += found->parameter >= 0 ? 1 : 0;
    ++wants_place;
    if (found->parameter < 0) show_miss(whole, token, "place: " + texts(*expected));
  }
};

// How often a name just before the cut means there what it means in the whole text: its
// declaration, its type, and all uses of it. Types that the text says only behind the cut count
// apart: they can be guessed at most. Neither is asked what only the next token says: a name in
// front of a colon is that of a setting or a field and may be any value before; behind `for (` it
// may be one that is there already.
struct MeaningCount {
  static constexpr std::size_t kLooksBack = 4;  // tokens
  int asked = 0;
  int unsaid_names = 0;  // not asked
  int same_place = 0;
  int same_uses = 0;
  int said = 0;  // before the cut
  int same_type = 0;
  int unsaid = 0;
  int guessed_type = 0;  // of those

  static bool says_more(std::uint16_t next, bool is_declared) {
    return is_declared ? next == RbtLexer::IN : next == lang::sign::kColon;
  }

  void count(const Analysis& whole, Said& types, const Analysis& cut,
             std::span<const lang::Token> before, const lang::Token& next) {
    const std::uint32_t end = next.begin;
    for (const lang::Token& token : before.last(std::min(before.size(), kLooksBack))) {
      if (!lang::is_name(token.type)) continue;
      const lang::Symbol* symbol = lang::symbol_at(whole.facts(), token.begin);
      if (symbol == nullptr || symbol->declared.source != 0 || symbol->declared.begin >= end)
        continue;
      const bool is_last = &token == &before.back();
      const bool is_declared = symbol->declared.begin == token.begin;
      if (is_last && says_more(next.type, is_declared)) {
        ++unsaid_names;
        continue;
      }
      ++asked;
      const bool has_place = cut.definition(token.begin) == symbol->declared;
      same_place += has_place ? 1 : 0;
      if (!has_place) show_miss(whole, token, "place");
      std::vector<Span> uses = whole.references(token.begin);
      std::erase_if(uses, [end](Span use) { return use.source == 0 && use.begin >= end; });
      const bool has_uses = cut.references(token.begin) == uses;
      same_uses += has_uses ? 1 : 0;
      if (!has_uses && has_place) show_miss(whole, token, "uses");
      const auto type = whole.hover(token.begin);
      const auto type_there = cut.hover(token.begin);
      const bool has_type = type && type_there && type->text == type_there->text;
      const bool is_said = types.until(*symbol) <= end;
      ++(is_said ? said : unsaid);
      (is_said ? same_type : guessed_type) += has_type ? 1 : 0;
      if (!has_type)
        show_miss(whole, token,
                  (is_said ? "type: " : "unsaid type: ") + (type ? type->text : "none") + " but " +
                      (type_there ? type_there->text : "none") + " at " + std::to_string(end));
    }
  }
};

}  // namespace

TEST_CASE("at every cut of every example what was written next is offered") {
  int asked = 0;
  int offered = 0;
  HelpCount help;
  MeaningCount meaning;
  for (const auto& path : programs_below("examples")) {
    const std::string text = read(path);
    Session session(library_engine(), options_for(path));
    const auto whole = session.analyse(text, path.filename().string());
    const lang::Tokens tokens = tokens_of(text);
    Said types(whole->facts());
    for (const lang::Token& token : tokens) {
      const auto cut = session.analyse(text.substr(0, token.begin), path.filename().string());
      const Completions list = cut->completion(token.begin);
      CHECK(list.replaced.end <= token.begin);
      (void)cut->hover(token.begin);
      (void)cut->signature_help(token.begin);
      if (&token != tokens.data()) help.count(*whole, *cut, *(&token - 1));
      meaning.count(*whole, types, *cut, {tokens.data(), &token}, token);
      (void)cut->inlay_hints();
      if (!lang::is_name(token.type) || !can_be_offered(whole->facts(), token)) continue;
      ++asked;
      const std::string word = text.substr(token.begin, token.end - token.begin);
      const bool found = offers(list, word);
      offered += found ? 1 : 0;
      if (!found) show_miss(*whole, token, word);
    }
  }
  MESSAGE("offered " << offered << " of " << asked);
  CHECK(asked > 1000);
  CHECK(offered >= asked * 995 / 1000);
  MESSAGE("helped at " << help.same << " of " << help.asked);
  CHECK(help.asked > 1000);
  CHECK(help.same >= help.asked * 99 / 100);
  CHECK(help.has_place >= help.wants_place * 99 / 100);
  MESSAGE("of " << meaning.asked << " names " << meaning.same_place << " with their place, "
                << meaning.same_uses << " with all uses; " << meaning.same_type << " of "
                << meaning.said << " with the type that is said, " << meaning.guessed_type << " of "
                << meaning.unsaid << " with one that is not");
  CHECK(meaning.asked > 4000);
  CHECK(meaning.unsaid_names < meaning.asked * 2 / 100);
  CHECK(meaning.same_place >= meaning.asked * 995 / 1000);
  CHECK(meaning.said > 4000);
  CHECK(meaning.same_type >= meaning.said * 995 / 1000);
  CHECK(meaning.same_uses >= meaning.asked * 99 / 100);
}
