#include "editor/cursor.hpp"

#include <algorithm>

#include "base/quotes.hpp"
#include "editor/places.hpp"
#include "syntax/tokens/signs.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

bool is_text(std::uint16_t type) {
  return type == sign::kText || type == sign::kFormattedText || type == sign::kUnclosedText;
}

bool is_word(std::uint16_t type) { return is_name(type) || !word_of(type).text.empty(); }

// The position of the opening brace, if the text is the beginning of a formatted text that ends
// inside of braces; npos otherwise.
std::size_t braces_of(std::string_view text) {
  const std::size_t open = text.rfind('{');
  const bool is_open =
      open != std::string_view::npos && text.find('}', open) == std::string_view::npos;
  return is_open ? open : std::string_view::npos;
}

// The colon that begins the format inside of braces; npos if there is none.
std::size_t colon_of(std::string_view piece) {
  int depth = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] == '(' || piece[i] == '[') ++depth;
    if (piece[i] == ')' || piece[i] == ']') --depth;
    if (piece[i] == ':' && depth == 0) return i;
  }
  return std::string_view::npos;
}

class Around {
 public:
  Around(const Facts& facts, std::uint32_t at) : facts_(facts), tokens_(facts.tokens) {
    out_.at = at;
    out_.word = {at, at, 0};
  }

  Cursor run() {
    out_.in_comment = facts_.in_comment(out_.at);
    if (out_.in_comment) return std::move(out_);
    find_word();
    out_.before = before_;
    const bool is_value = !out_.number && !out_.in_braces;
    if (is_value && before_ > 0 && tokens_[before_ - 1].type == sign::kPoint)
      out_.point = tokens_[before_ - 1];
    find_call();
    return std::move(out_);
  }

 private:
  // Sets `word`, `quoted` and the count of tokens before the word.
  void find_word() {
    before_ = facts_.token_behind(out_.at);
    if (before_ >= tokens_.size()) return;
    const Token& token = tokens_[before_];
    const bool inside = token.begin < out_.at && out_.at <= token.end && token.type != kEndOfText;
    if (inside && is_text(token.type)) return find_word_in_text(token);
    if (inside && (is_number(token.type) || token.type == sign::kBadNumber))
      return find_unit(token);
    if (inside && is_word(token.type)) {
      out_.word = {token.begin, token.end, 0};
    } else if (token.end <= out_.at && token.type != kEndOfText) {
      ++before_;
    }
    // A word that begins at the position is the one being written.
    const bool begins = before_ < tokens_.size() && tokens_[before_].begin == out_.at &&
                        tokens_[before_].type != kEndOfText && is_word(tokens_[before_].type);
    if (begins) out_.word = {tokens_[before_].begin, tokens_[before_].end, 0};
  }

  // 100mm/s|: finds the last unit of a product, up to the position.
  void find_unit(const Token& token) {
    const std::string_view text = facts_.text_of(token);
    const std::size_t at = out_.at - token.begin;
    std::size_t first = std::min(unit_begin(text), at);
    const std::size_t sign = text.substr(0, at).find_last_of("*/");
    if (sign != std::string_view::npos) first = std::max(first, sign + 1);
    const std::size_t last = std::min(text.find_first_of("*/^", at), text.size());
    out_.word = {token.begin + static_cast<std::uint32_t>(first),
                 token.begin + static_cast<std::uint32_t>(last), 0};
    out_.number = token;
  }

  void find_word_in_text(const Token& token) {
    const std::string_view text = facts_.text_of(token);
    const bool is_closed = token.type != sign::kUnclosedText;
    if (is_closed && out_.at == token.end) {
      ++before_;
      return;
    }
    const Quotes quotes = quotes_of(text);
    const auto begin = token.begin + static_cast<std::uint32_t>(quotes.opening);
    const auto end = is_closed ? token.end - static_cast<std::uint32_t>(quotes.closing) : out_.at;
    if (out_.at < begin || out_.at > end) return;
    const std::size_t braces = braces_of(text.substr(0, out_.at - token.begin));
    if (text.starts_with('f') && braces != std::string_view::npos)
      return find_word_in_braces(token, text, braces + 1);
    out_.quoted = token;
    out_.word = {begin, end, 0};
  }

  // f"{left.na|}": searches bytes, because the formatted text is a single token.
  void find_word_in_braces(const Token& token, std::string_view text, std::size_t begin) {
    const auto at = static_cast<std::size_t>(out_.at - token.begin);
    std::size_t first = at;
    std::size_t last = at;
    while (first > 0 && is_word_character(text[first - 1])) --first;
    while (last < text.size() && is_word_character(text[last])) ++last;
    out_.word = {token.begin + static_cast<std::uint32_t>(first),
                 token.begin + static_cast<std::uint32_t>(last), 0};
    if (first > 0 && text[first - 1] == '.')
      out_.point =
          Token{.begin = out_.word.begin - 1, .end = out_.word.begin, .type = sign::kPoint};
    out_.in_braces = true;
    const std::size_t colon = colon_of(text.substr(begin, at - begin));
    if (colon == std::string_view::npos) return;
    out_.point.reset();
    const auto value = token.begin + static_cast<std::uint32_t>(begin);
    out_.format = Span{value, value + static_cast<std::uint32_t>(colon), 0};
  }

  void find_call() {
    if (out_.in_braces) return;
    std::size_t depth = 0;
    bool directly = true;
    for (std::size_t i = before_; i-- > 0;) {
      const Token& token = tokens_[i];
      if (is_closer(token.type)) ++depth;
      if (depth == 0 && (token.type == sign::kOpenParenthesis || token.type == sign::kOpenBrace)) {
        if (token.type == sign::kOpenParenthesis ? open_call(i) : open_block(i)) {
          out_.call->directly = directly;
          if (token.type == sign::kOpenParenthesis) read_values(i);
          if (token.type == sign::kOpenBrace) read_fields(i);
        }
        if (out_.call || token.type == sign::kOpenBrace) return;
      }
      if (depth == 0 && is_opener(token.type)) directly = false;
      if (depth > 0 && is_opener(token.type)) --depth;
      if (depth == 0 && token.line_break_before && word_of(token.type).resumes) return;
    }
  }

  bool open_call(std::size_t opener) {
    if (opener == 0) return false;
    const Token& before = tokens_[opener - 1];
    // The header of a lambda.
    if (opener > 1 && word_of(tokens_[opener - 2].type).text == "fn") return false;
    OpenCall call;
    call.callee = {before.begin, before.end, 0};
    if (before.type == sign::kWith || before.type == sign::kPath) {
      call.kind = before.type == sign::kWith ? OpenCall::Kind::kWith : OpenCall::Kind::kPath;
      call.name = facts_.text_of(before);
    } else if (!is_name(before.type) && !is_primitive_type(before.type)) {
      return false;
    } else {
      call.name = facts_.text_of(before);
      for (std::size_t i = opener - 1; i >= 2 && tokens_[i - 1].type == sign::kPoint; i -= 2) {
        call.behind_point = true;
        if (!is_name(tokens_[i - 2].type)) break;
        call.name = std::string(facts_.text_of(tokens_[i - 2])) + '.' + call.name;
      }
      if (opener >= 2 && is_name(tokens_[opener - 2].type)) call.name = row_maker(opener);
      // A group of the library is part of a function's name; other names before a point are values.
      if (facts_.registry->functions(call.name).empty()) {
        call.name = facts_.text_of(before);
      } else {
        call.behind_point = call.name == facts_.text_of(before) && call.behind_point;
      }
    }
    out_.call = std::move(call);
    return true;
  }

  // phase wound(: the function "motor.phase.wound", which makes a row of a block declaration.
  std::string row_maker(std::size_t opener) const {
    const std::string name(facts_.text_of(tokens_[opener - 1]));
    const std::string row = '.' + std::string(facts_.text_of(tokens_[opener - 2])) + '.' + name;
    for (const auto& [type, unused] : facts_.registry->types()) {
      if (!facts_.registry->functions(type + row).empty()) return type + row;
      // The row has a name.
      std::string named = type + '.' + std::string(facts_.text_of(tokens_[opener - 2]));
      named += kNamedRow;
      if (!facts_.registry->functions(named).empty()) return named;
    }
    return name;
  }

  bool open_block(std::size_t opener) {
    if (opener < 2 || !is_name(tokens_[opener - 1].type) || !is_name(tokens_[opener - 2].type))
      return false;
    OpenCall call{.kind = OpenCall::Kind::kBlock};
    call.name = facts_.text_of(tokens_[opener - 2]);
    call.callee = {tokens_[opener - 2].begin, tokens_[opener - 2].end, 0};
    out_.call = std::move(call);
    return true;
  }

  // The arguments before the position, and the names of settings on both sides of it.
  void read_values(std::size_t opener) {
    OpenCall& call = *out_.call;
    std::size_t depth = 0;
    bool begins = true;
    bool named = false;
    for (std::size_t i = opener + 1; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      const bool is_before = i < before_;
      if (depth == 0 && is_closer(token.type)) return;
      if (depth == 0 && token.type == sign::kSemicolon) return;
      if (depth == 0 && begins && is_name(token.type) && tokens_[i + 1].type == sign::kColon &&
          token.begin != out_.word.begin) {
        call.given.push_back(facts_.text_of(token));
        named = true;
        if (i + 1 < before_) call.setting = facts_.text_of(token);
      } else if (depth == 0 && begins && is_before) {
        call.earlier.push_back({token.begin, token.end, 0});
      }
      begins = false;
      if (is_opener(token.type)) ++depth;
      if (is_closer(token.type)) --depth;
      if (depth != 0 || token.type != sign::kComma) continue;
      begins = true;
      if (is_before) {
        call.values += named ? 0 : 1;
        call.setting = {};
      }
      named = false;
    }
  }

  void read_fields(std::size_t opener) {
    OpenCall& call = *out_.call;
    std::size_t depth = 0;
    for (std::size_t i = opener + 1; i + 1 < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (depth == 0 && is_closer(token.type)) return;
      if (is_opener(token.type)) ++depth;
      if (is_closer(token.type)) --depth;
      const bool ends = token.type == sign::kSemicolon || token.type == sign::kComma ||
                        tokens_[i + 1].line_break_before;
      if (depth == 0 && i < before_ && ends) call.setting = {};
      if (depth != 0 || !is_name(token.type) || tokens_[i + 1].type != sign::kColon) continue;
      if (token.begin == out_.word.begin) continue;
      call.given.push_back(facts_.text_of(token));
      if (i + 1 < before_) call.setting = facts_.text_of(token);
    }
  }

  const Facts& facts_;
  const Tokens& tokens_;
  Cursor out_{};
  std::size_t before_ = 0;
};

bool is_ambient(const Parameter& parameter) {
  const Type* type = parameter.type.type;
  return type != nullptr && type->is(Kind::kHost) && type->host->is_ambient;
}

}  // namespace

Cursor cursor_at(const Facts& facts, std::uint32_t at) { return Around(facts, at).run(); }

std::vector<const NativeFunction*> candidates(const Facts& facts, const OpenCall& call) {
  std::vector<const NativeFunction*> out;
  const auto add = [&](std::string_view name) {
    for (const NativeFunction* function : facts.registry->functions(name)) {
      if (!function->help.empty()) out.push_back(function);
    }
  };
  if (call.kind == OpenCall::Kind::kBlock) {
    add(call.name + "{}");
    return out;
  }
  if (call.kind != OpenCall::Kind::kCall) return out;
  if (call.behind_point) {
    const std::size_t behind = facts.token_behind(call.callee.begin);
    if (behind < facts.tokens.size() && facts.tokens[behind].type == sign::kPoint) {
      if (const Type* type = receiver_type(facts, facts.tokens[behind]))
        add(type_name(type) + '.' + call.name);
    }
  }
  if (out.empty()) add(call.name);
  return out;
}

const Symbol* callee_symbol(const Facts& facts, const OpenCall& call, std::uint32_t at) {
  if (call.kind == OpenCall::Kind::kWith || call.kind == OpenCall::Kind::kPath) return nullptr;
  const Reference* known = facts.reference_at(call.callee.begin);
  if (known != nullptr && known->name == call.callee) return &facts.names.symbols[known->symbol];
  if (const Symbol* visible = facts.visible_at(at, call.name)) return visible;
  if (!call.behind_point) return nullptr;
  // A function of an imported file may be called on a value of a type of that file.
  const auto is_it = [&](const Symbol& symbol) {
    return symbol.function != nullptr && symbol.of_file && symbol.name == call.name;
  };
  const auto found = std::ranges::find_if(facts.names.symbols, is_it);
  return found != facts.names.symbols.end() ? &*found : nullptr;
}

int parameter_of(const Facts& facts, const OpenCall& call, const NativeFunction& function) {
  const Signature& signature = facts.signed_->signatures.of(function);
  if (!call.setting.empty()) return signature.index_of(call.setting);
  if (signature.parameters.empty()) return -1;
  std::size_t first = call.behind_point ? 1 : 0;
  if (first == 0 && is_ambient(signature.parameters[0])) {
    // The first argument may be the ambient value.
    first = 1;
    const Type* given = nullptr;
    if (!call.earlier.empty()) {
      const std::uint32_t begin = call.earlier[0].begin;
      const auto value = std::ranges::lower_bound(facts.values.spans, begin, {},
                                                  [](const TypedSpan& v) { return v.span.begin; });
      if (value != facts.values.spans.end() && value->span.begin == begin) given = value->type;
    }
    if (given == signature.parameters[0].type.type) first = 0;
  }
  const std::size_t at = first + static_cast<std::size_t>(call.values);
  if (at < signature.parameters.size()) return static_cast<int>(at);
  return signature.parameters.back().variadic ? static_cast<int>(signature.parameters.size()) - 1
                                              : -1;
}

const Type* receiver_type(const Facts& facts, const Token& point) {
  const auto found = std::ranges::lower_bound(
      facts.members, point.end, {}, [](const ast::MemberExpr* m) { return m->member.span.begin; });
  const std::size_t next = facts.token_behind(point.end) + 1;
  const std::uint32_t limit = next < facts.tokens.size()
                                  ? facts.tokens[next].begin
                                  : static_cast<std::uint32_t>(facts.main().text().size());
  if (found != facts.members.end() && (*found)->member.span.begin <= limit &&
      (*found)->object->span.end <= point.begin) {
    const auto known = facts.values.type_of.find((*found)->object);
    if (known != facts.values.type_of.end() && !known->second->is(Kind::kAny)) return known->second;
  }
  const std::size_t behind = facts.token_behind(point.begin);
  if (behind >= facts.tokens.size() || facts.tokens[behind].end != point.begin) return nullptr;
  const bool is_chain = behind > 0 && facts.tokens[behind - 1].type == sign::kPoint;
  const Symbol* symbol =
      is_chain ? nullptr : facts.visible_at(point.begin, facts.text_of(facts.tokens[behind]));
  return symbol != nullptr ? symbol->type : nullptr;
}

}  // namespace armlet::lang
