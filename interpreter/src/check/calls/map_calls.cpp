// Checks the methods of maps, and explains their names in other languages.

#include <algorithm>
#include <array>
#include <utility>

#include "check/calls/intrinsics.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {
namespace {

using hir::MapQuestion;

// A method of another language and its form in this one. $m is the map, $1 and $2 are the arguments
// of the call.
struct ForeignMethod {
  std::string_view name;
  std::size_t values;
  std::string_view here;
};

constexpr auto kForeign = std::to_array<ForeignMethod>({
    {"put", 2, "$m[$1] = $2"},
    {"set", 2, "$m[$1] = $2"},
    {"add", 2, "$m[$1] = $2"},
    {"insert", 2, "$m[$1] = $2"},
    {"at", 1, "$m[$1]"},
    {"getOrDefault", 2, "$m.get($1, $2)"},
    {"containsKey", 1, "$m.has($1)"},
    {"has_key", 1, "$m.has($1)"},
    {"hasKey", 1, "$m.has($1)"},
    {"isKey", 1, "$m.has($1)"},
    {"contains", 1, "$m.has($1)"},
    {"includes", 1, "$m.has($1)"},
    {"containsValue", 1, "$m.values().contains($1)"},
    {"delete", 1, "$m.remove($1)"},
    {"erase", 1, "$m.remove($1)"},
    {"pop", 1, "$m.remove($1)"},
    {"items", 0, "$m"},
    {"entries", 0, "$m"},
    {"entrySet", 0, "$m"},
    {"iteritems", 0, "$m"},
    {"keySet", 0, "$m.keys()"},
    {"size", 0, "$m.length"},
    {"count", 0, "$m.length"},
    {"len", 0, "$m.length"},
    {"isEmpty", 0, "($m.length == 0)"},
    {"empty", 0, "($m.length == 0)"},
    {"clear", 0, "$m = [:]"},
});

constexpr std::array<std::string_view, 6> kMethods = {"get",  "has",    "remove",
                                                      "keys", "values", "length"};

hir::Expr* foreign_method_of_map(Checker& checker, const ast::CallExpr& call,
                                 const ast::MemberExpr& member) {
  const auto is_called = [&](const ForeignMethod& method) {
    return method.name == member.member.text && method.values == call.args.size();
  };
  const auto found = std::ranges::find_if(kForeign, is_called);
  if (found == kForeign.end()) return nullptr;
  std::string here;
  for (std::size_t i = 0; i < found->here.size(); ++i) {
    if (found->here[i] != '$') {
      here += found->here[i];
      continue;
    }
    const char part = found->here[++i];
    here +=
        checker.text_of(part == 'm' ? member.object->span
                                    : call.args[static_cast<std::size_t>(part - '1')].value->span);
  }
  Diagnostic diagnostic =
      make_diagnostic("E0201", member.member.span, {std::string(member.member.text)});
  diagnostic.fix =
      Fix{.text = "write " + here, .edits = {{call.span, here}}, .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

hir::Expr* key_argument(Checker& checker, const ast::CallExpr& call, const Type* map,
                        std::string_view name) {
  return checker.check_as(*call.args[0].value, {.role = Target::Role::kArgument,
                                                .type = map->key,
                                                .name = "key",
                                                .function = name,
                                                .position = 1,
                                                .call = call.span});
}

hir::Expr* remove_call(Checker& checker, const ast::CallExpr& call, const ast::MemberExpr& member) {
  if (!takes(checker, call, "remove", 1, 1)) return checker.failed(call.span);
  const auto place = checker.check_place(*member.object, call.span, false);
  if (!place) return checker.failed(call.span);
  hir::Expr* key = key_argument(checker, call, place->type, "remove");
  if (key->type->is(Kind::kAny)) return key;
  return checker.make<hir::MutateExpr>(hir::ExprKind::kMutate, place->type->element, call.span,
                                       hir::Mutation::kRemoveKey, *place, key, nullptr);
}

hir::Expr* get_call(Checker& checker, hir::Expr* map, const ast::CallExpr& call) {
  const Type* element = map->type->element;
  if (call.args.size() == 1) {
    const Span name = call.callee->as<ast::MemberExpr>().member.span;
    Diagnostic missing = make_diagnostic("E0312", name, {"get", "2 values", "1"});
    missing.why = "`otherwise:` is missing, the value for a key that the map does not have";
    checker.report(std::move(missing));
    return checker.failed(call.span);
  }
  if (!takes(checker, call, "get", 2, 2)) return checker.failed(call.span);
  hir::Expr* key = key_argument(checker, call, map->type, "get");
  hir::Expr* otherwise = checker.check_as(*call.args[1].value, {.role = Target::Role::kArgument,
                                                                .type = element,
                                                                .name = "otherwise",
                                                                .function = "get",
                                                                .position = 2,
                                                                .call = call.span});
  if (key->type->is(Kind::kAny) || otherwise->type->is(Kind::kAny))
    return checker.failed(call.span);
  return checker.make<hir::EntryExpr>(hir::ExprKind::kEntry, element, call.span, map, key,
                                      otherwise);
}

hir::Expr* has_call(Checker& checker, hir::Expr* map, const ast::CallExpr& call) {
  if (!takes(checker, call, "has", 1, 1)) return checker.failed(call.span);
  hir::Expr* key = key_argument(checker, call, map->type, "has");
  if (key->type->is(Kind::kAny)) return key;
  return checker.make<hir::MapQueryExpr>(hir::ExprKind::kMapQuery, checker.types.boolean(),
                                         call.span, MapQuestion::kHas, map, key);
}

}  // namespace

hir::Expr* call_of_map(Checker& checker, hir::Expr* map, const ast::CallExpr& call,
                       const ast::MemberExpr& member) {
  const std::string_view name = member.member.text;
  const auto no_values = [&] { return takes(checker, call, name, 0, 0); };
  if (map->type->element->is(Kind::kAny)) {
    checker.report(make_diagnostic("E0323", map->span, {"this empty map"}));
    return checker.failed(call.span);
  }
  if (checker.names.find_function(name) == nullptr) {
    if (hir::Expr* told = foreign_method_of_map(checker, call, member)) return told;
  }
  if (name == "get") return get_call(checker, map, call);
  if (name == "has") return has_call(checker, map, call);
  if (name == "remove") return remove_call(checker, call, member);
  if (name == "clone") return no_values() ? map : checker.failed(call.span);
  if (name == "keys" || name == "values") {
    if (!no_values()) return checker.failed(call.span);
    const auto question = name == "keys" ? MapQuestion::kKeys : MapQuestion::kValues;
    return parts_of_map(checker, question, map, call.span);
  }
  return nullptr;
}

hir::Expr* foreign_empty_map(Checker& checker, std::string_view name, std::size_t values,
                             Span span) {
  constexpr std::array<std::string_view, 8> kTypes = {
      "dict", "Dict", "Map", "HashMap", "TreeMap", "Dictionary", "OrderedDict", "defaultdict"};
  if (std::ranges::find(kTypes, name) == kTypes.end() || values != 0) return nullptr;
  Diagnostic diagnostic = make_diagnostic("E0201", span, {std::string(name)});
  Fix fix{.text = "write [:]", .edits = {{span, "[:]"}}};
  // var stock = dict(): the type is written after the name.
  const std::string_view text = (*checker.into.sources)[span.source].text();
  const std::string_view before = text.substr(0, span.begin);
  const std::size_t equals = before.find_last_not_of(" \t");
  const std::string_view declared = checker.surroundings.name_for(span);
  const std::size_t end = equals == std::string_view::npos || before[equals] != '=' || equals == 0
                              ? std::string_view::npos
                              : before.find_last_not_of(" \t", equals - 1);
  if (!declared.empty() && end != std::string_view::npos &&
      before.substr(0, end + 1).ends_with(declared)) {
    const auto at = static_cast<std::uint32_t>(end + 1);
    fix.text = "write " + std::string(declared) + ": int[string] = [:]";
    fix.edits.insert(fix.edits.begin(), {{at, at, span.source}, ": int[string]"});
  }
  diagnostic.fix = std::move(fix);
  checker.report(std::move(diagnostic));
  return checker.failed(span);
}

std::optional<Fix> fix_of_map_member(const Checker& checker, const Type* map,
                                     const ast::Name& member) {
  const std::string name(member.text);
  if (std::ranges::find(kMethods, member.text) != kMethods.end())
    return Fix{.text = "write " + name + "()", .edits = {{member.span, name + "()"}}};
  if (name == "size" || name == "count")
    return Fix{.text = "write length", .edits = {{member.span, "length"}}};
  if (!map->key->is(Kind::kText)) return std::nullopt;
  const Span with_dot{member.span.begin - 1, member.span.end, member.span.source};
  if (checker.text_of(with_dot) != '.' + name) return std::nullopt;
  const std::string entry = "[\"" + name + "\"]";
  return Fix{.text = "an entry is written " + entry, .edits = {{with_dot, entry}}};
}

}  // namespace armlet::lang
