#include "moves/move_around.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/cell/collisions.hpp"
#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

// Two bodies by name; all bodies of a link have the same name.
struct NamedPair {
  std::string first, second;
  double depth = 0.0;
  double share = 0.0;

  [[nodiscard]] std::string text() const { return fmt::format("{} and {}", first, second); }
};

std::vector<NamedPair> named(const Cell& cell, const std::vector<BlockingBodies>& blocking) {
  std::vector<NamedPair> all;
  for (const BlockingBodies& each : blocking) {
    NamedPair pair{body_text(cell, each.body), body_text(cell, each.other), each.depth, each.share};
    const auto same = std::ranges::find_if(all, [&](const NamedPair& known) {
      return known.first == pair.first && known.second == pair.second;
    });
    if (same == all.end()) {
      all.push_back(std::move(pair));
      continue;
    }
    same->depth = std::max(same->depth, pair.depth);
    same->share += pair.share;
  }
  return all;
}

Failure about(Vm& vm, const MoveCall& call) {
  Failure f;
  f.kind = "Collision";
  f.mark = CallPart::callee();
  f.place = call.place;
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  return f;
}

// R0643: the start or the goal of the path collides.
Failed fail_end(Vm& vm, const MoveCall& call, const WayAround& around, std::size_t goals) {
  const Cell& cell = Host::of(vm).cell();
  const bool at_start = around.way.status == WayStatus::kStartCollides;
  std::vector<NamedPair> pairs = named(cell, around.blocking);
  std::ranges::stable_sort(
      pairs, [](const NamedPair& a, const NamedPair& b) { return a.depth > b.depth; });
  Failure f = about(vm, call);
  f.headline = {
      row("R0643"),
      {pairs[0].first, pairs[0].second, at_start ? "where the robot stands" : "at the target"}};
  f.why = fmt::format("{} deep", format_mm(pairs[0].depth));
  for (std::size_t k = 1; k < pairs.size(); ++k)
    f.why += fmt::format("; {} too, {} deep", pairs[k].text(), format_mm(pairs[k].depth));
  if (goals > 1 && !at_start)
    f.why += fmt::format("; each of the {} solutions for this target collides", goals);
  if (!at_start) f.mark = call.target;
  f.fix = at_start ? "free the two before: move straight away from there with moveL"
                   : "choose another target, or another orientation there";
  return fail(vm, std::move(f));
}

// "link 3 of `arm` and "wall" (61 %), ...": shares of all collisions found during the path search.
std::string most_in_the_way(const Cell& cell, const std::vector<BlockingBodies>& blocking) {
  constexpr std::size_t kMost = 3;
  constexpr double kSeldom = 0.005;
  std::vector<NamedPair> pairs = named(cell, blocking);
  std::ranges::stable_sort(
      pairs, [](const NamedPair& a, const NamedPair& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t k = 0; k < std::min(pairs.size(), kMost) && pairs[k].share > kSeldom; ++k) {
    text +=
        fmt::format("{}{} ({:.0f} %)", k == 0 ? "" : ", ", pairs[k].text(), 100.0 * pairs[k].share);
  }
  return text;
}

Failed fail_search(Vm& vm, const MoveCall& call, const WayAround& around) {
  const Cell& cell = Host::of(vm).cell();
  Failure f = about(vm, call);
  const std::string blocking = most_in_the_way(cell, around.blocking);
  if (around.way.status == WayStatus::kCannotSearch) {
    f.headline = Headline(row("R0646"));
    f.why = fmt::format("it was built without OMPL, or its library was not found; in the way: {}",
                        blocking);
    f.fix = "go round through points in between";
    return fail(vm, std::move(f));
  }
  f.headline = {row("R0644"), {cell.robot(call.robot).name}};
  f.why = fmt::format("{} steps of the search; most often in the way: {}", around.way.iterations,
                      blocking);
  f.fix =
      "make room there, or go through a point in between; plan(..., iterations: 100000) "
      "searches longer";
  return fail(vm, std::move(f));
}

}  // namespace

Failed fail_no_way(Vm& vm, const MoveCall& call, const refused::NoWayAround& why) {
  const WayStatus status = why.around.way.status;
  const bool is_end = status == WayStatus::kStartCollides || status == WayStatus::kGoalCollides;
  return is_end ? fail_end(vm, call, why.around, why.goals) : fail_search(vm, call, why.around);
}

}  // namespace armlet::bind
