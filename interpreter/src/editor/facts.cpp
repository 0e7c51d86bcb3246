#include "editor/facts.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_set>

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

InnermostSpans::InnermostSpans(std::span<const Span> spans) {
  std::vector<std::uint32_t> open;
  const auto close_before = [&](std::uint32_t byte) {
    while (!open.empty() && spans[open.back()].end <= byte) {
      const std::uint32_t end = spans[open.back()].end;
      open.pop_back();
      segments_.push_back({end, open.empty() ? kNothing : open.back()});
    }
  };
  for (std::uint32_t i = 0; i < spans.size(); ++i) {
    if (spans[i].empty()) continue;
    close_before(spans[i].begin);
    segments_.push_back({spans[i].begin, i});
    open.push_back(i);
  }
  close_before(0xFFFFFFFF);
}

std::uint32_t InnermostSpans::at(std::uint32_t byte) const {
  const auto behind = std::ranges::upper_bound(segments_, byte, {}, &Segment::begin);
  return behind == segments_.begin() ? kNothing : (behind - 1)->span;
}

std::uint32_t Facts::place(std::uint32_t at) const {
  const std::string_view text = main().text();
  at = std::min(at, static_cast<std::uint32_t>(text.size()));
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
    --at;
  return at;
}

namespace {

// Finds the name with the byte in names sorted by their position in the main text; if there is
// none, the name that ends there.
template <class Named>
const Named* name_at(const std::vector<Named>& names, std::uint32_t source, std::uint32_t at) {
  auto behind = std::ranges::upper_bound(names, std::tuple(source, at), {}, [](const Named& one) {
    return std::tuple(one.name.source, one.name.begin);
  });
  if (behind == names.begin()) return nullptr;
  const Named& found = *(behind - 1);
  if (found.name.source != source) return nullptr;
  if (at < found.name.end) return &found;
  return at == found.name.end ? &found : nullptr;
}

}  // namespace

std::span<const Reference> Facts::uses_of(const Symbol& symbol) const {
  const auto index = static_cast<std::uint32_t>(&symbol - names.symbols.data());
  const auto first = std::ranges::lower_bound(names.by_symbol, index, {}, &Reference::symbol);
  const auto last = std::ranges::upper_bound(names.by_symbol, index, {}, &Reference::symbol);
  return std::span(names.by_symbol)
      .subspan(static_cast<std::size_t>(first - names.by_symbol.begin()),
               static_cast<std::size_t>(last - first));
}

const Reference* Facts::reference_at(std::uint32_t at) const {
  return name_at(names.references, main_source(), at);
}

const Learnt::NativeUse* Facts::native_at(std::uint32_t at) const {
  return name_at(natives, main_source(), at);
}

const Symbol* Facts::declared_at(Span name) const {
  const auto key = [](const Symbol& s) { return std::tuple(s.declared.source, s.declared.begin); };
  const auto found =
      std::ranges::lower_bound(names.symbols, std::tuple(name.source, name.begin), {}, key);
  return found != names.symbols.end() && found->declared == name ? &*found : nullptr;
}

std::vector<const Symbol*> Facts::visible_at(std::uint32_t at) const {
  const auto behind = std::ranges::upper_bound(functions, at, {}, &Span::begin);
  const bool in_function = behind != functions.begin() && at < (behind - 1)->end;
  std::vector<const Symbol*> out;
  for (const Symbol& symbol : names.symbols) {
    const bool here = symbol.visible.begin <= at && at <= symbol.visible.end;
    if (symbol.visible.source != main_source() || symbol.visible.empty()) continue;
    if (here || (symbol.of_file && in_function)) out.push_back(&symbol);
  }
  // In one scope the last declaration comes first, because it hides the others.
  std::ranges::stable_sort(out, [](const Symbol* a, const Symbol* b) {
    return std::tuple(a->scope, b->declared.begin) < std::tuple(b->scope, a->declared.begin);
  });
  std::unordered_set<std::string_view> met;
  std::erase_if(out, [&](const Symbol* symbol) {
    return symbol->name.empty() || !met.insert(symbol->name).second;
  });
  return out;
}

const Symbol* Facts::visible_at(std::uint32_t at, std::string_view name) const {
  for (const Symbol* symbol : visible_at(at)) {
    if (symbol->name == name) return symbol;
  }
  return nullptr;
}

std::size_t Facts::token_behind(std::uint32_t at) const {
  const auto found = std::ranges::lower_bound(tokens, at, {}, &Token::end);
  return static_cast<std::size_t>(found - tokens.begin());
}

bool Facts::in_comment(std::uint32_t at) const {
  const auto behind = std::ranges::lower_bound(comments, at, {}, &Span::begin);
  if (behind == comments.begin()) return false;
  const Span& comment = *(behind - 1);
  const bool of_line = main().slice(comment).starts_with("//");
  return at < comment.end || (of_line && at == comment.end);
}

std::string described(const Facts& facts, const Symbol& symbol) {
  const std::string name(symbol.name);
  switch (symbol.kind) {
    case NameKind::kFunction: {
      std::string out(symbol.header);
      const Type* result = facts.learnt.result_of(symbol.declared);
      const bool says = symbol.function != nullptr &&
                        (symbol.function->result != nullptr || symbol.function->classic);
      if (!says && result != nullptr && !result->is(Kind::kVoid) && !result->is(Kind::kAny))
        out += " -> " + type_name(result);
      return out;
    }
    case NameKind::kStruct:
    case NameKind::kEnum:
    case NameKind::kModule:
      return std::string(symbol.header);
    case NameKind::kEnumValue:
      return std::string(symbol.header) + '.' + name;
    case NameKind::kVariable:
    case NameKind::kParameter:
    case NameKind::kField:
    case NameKind::kLibraryFunction:
    case NameKind::kConstant:
    case NameKind::kType:
    case NameKind::kSetting:
    case NameKind::kWord:
    case NameKind::kText:
      break;
  }
  if (symbol.type == nullptr || symbol.type->is(Kind::kAny)) return name;
  return name + ": " + type_name(symbol.type);
}

}  // namespace armlet::lang
