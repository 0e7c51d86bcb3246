// Functions of lists that visit every element: plain loops.

#include <algorithm>

#include "evaluator.hpp"

namespace armlet::oracle {

using namespace lang::hir;

namespace {

bool comes_before(const Value& a, const Value& b) {
  if (std::holds_alternative<std::int64_t>(a.is)) return a.integer() < b.integer();
  if (std::holds_alternative<double>(a.is)) return a.real() < b.real();
  return a.text() < b.text();
}

}  // namespace

Value Evaluator::over_list(const OverListExpr& e) {
  const Values operands = evaluate_all(e.operands);
  const Values& items = operands[0].list().items;
  const auto run = [&](Values arguments) {
    const bool sorts = e.verb == ListVerb::kSort;  // the direction comes behind the function
    const Closure& function = (sorts ? operands[1] : operands.back()).closure();
    return call(*function.function, std::move(arguments), function.captures, e.span);
  };
  const auto item_at = [&](std::size_t i) -> const Value& {
    return set_item(operands[0], i, e.operands[0]->span);
  };
  const std::size_t count = items.size();
  List out;
  switch (e.verb) {
    case ListVerb::kMap:
      for (std::size_t i = 0; i < count; ++i) out.items.push_back(run({item_at(i)}));
      return {std::move(out)};
    case ListVerb::kFilter:
      for (std::size_t i = 0; i < count; ++i) {
        if (run({item_at(i)}).truth()) out.items.push_back(items[i]);
      }
      return {std::move(out)};
    case ListVerb::kFold: {
      Value all = operands[1];
      for (std::size_t i = 0; i < count; ++i) all = run({all, item_at(i)});
      return all;
    }
    case ListVerb::kAny:
    case ListVerb::kAll:
      for (std::size_t i = 0; i < count; ++i) {
        if (run({item_at(i)}).truth() == (e.verb == ListVerb::kAny))
          return {e.verb == ListVerb::kAny};
      }
      return {e.verb == ListVerb::kAll};
    case ListVerb::kSort: {
      std::vector<std::pair<Value, Value>> keyed;
      for (std::size_t i = 0; i < count; ++i) keyed.emplace_back(run({item_at(i)}), items[i]);
      const bool descending = operands[2].truth();
      std::ranges::stable_sort(
          keyed,
          [=](const Value& a, const Value& b) {
            return descending ? comes_before(b, a) : comes_before(a, b);
          },
          [](const auto& pair) -> const Value& { return pair.first; });
      for (auto& [key, item] : keyed) out.items.push_back(std::move(item));
      return {std::move(out)};
    }
    default:
      return look_up(e, operands);
  }
}

// zip, contains, indexOf.
Value Evaluator::look_up(const OverListExpr& e, const Values& operands) {
  const Values& items = operands[0].list().items;
  if (e.verb == ListVerb::kZip) {
    const Values& others = operands[1].list().items;
    if (items.size() != others.size())
      fail("R0613", e.span,
           {std::to_string(items.size()) + " and " + std::to_string(others.size()) + " values"});
    List out;
    for (std::size_t i = 0; i < items.size(); ++i) {
      Value first = set_item(operands[0], i, e.operands[0]->span);
      Value second = set_item(operands[1], i, e.operands[1]->span);
      out.items.push_back({Record{{std::move(first), std::move(second)}, nullptr}});
    }
    return {std::move(out)};
  }
  for (std::size_t i = 0; i < 2; ++i)
    check_whole(operands[i], *e.operands[i]->type, e.operands[i]->span);
  const auto found =
      std::ranges::find_if(items, [&](const Value& item) { return equal(item, operands[1]); });
  if (e.verb == ListVerb::kContains) return {found != items.end()};
  return {found == items.end() ? std::int64_t{-1}
                               : static_cast<std::int64_t>(found - items.begin())};
}

}  // namespace armlet::oracle
