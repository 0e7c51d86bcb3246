#include "values/robots/own_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/collision/own_pairs.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"

namespace armlet::bind {
namespace {

int link_called(const Robot& robot, std::string_view word, std::string_view name) {
  const int link = link_of_name(robot, name);
  if (link >= 0) return link;
  std::string known;
  for (int i = 0; i <= robot.rows(); ++i) {
    const std::vector<std::string>& names = robot.body(i).names;
    const std::string number = i == 0 ? "base" : fmt::format("link {}", i);
    known += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names.empty() ? number : names.front());
  }
  throw ArgumentError(fmt::format("`{}` names \"{}\", which is no link of robot `{}`; it has {}.",
                                  word, name, robot.name(), known));
}

std::vector<LinkPair> read_pairs(const Robot& robot, std::string_view word, NamePairs rows) {
  std::vector<LinkPair> pairs;
  if (!rows) return pairs;
  for (const Slot row : *rows) {
    const std::span<const Slot> names = items_value(row);
    if (names.size() != 2) {
      throw ArgumentError(fmt::format(
          "`{}` takes pairs of names, such as [\"base\", \"link 3\"]; this row of robot "
          "`{}` has {}.",
          word, robot.name(), names.size()));
    }
    const int first = link_called(robot, word, text_value(names[0])),
              second = link_called(robot, word, text_value(names[1]));
    if (first == second) {
      throw ArgumentError(fmt::format(
          "`{}` names \"{}\" and \"{}\", which are one link of robot `{}`; expected two "
          "links that move against each other.",
          word, text_value(names[0]), text_value(names[1]), robot.name()));
    }
    pairs.emplace_back(std::max(first, second), std::min(first, second));
  }
  return pairs;
}

std::string pair_text(const Robot& robot, LinkPair links) {
  return fmt::format("{} and {}", link_text(robot, links.first), link_text(robot, links.second));
}

std::string_view reason_text(ExemptReason reason) {
  constexpr std::array<std::string_view, 4> kWords = {
      "neighbours", "overlap nearly everywhere",
      "on joints of parallel axes alone, perhaps side by side", "allowed by name"};
  return kWords[static_cast<std::size_t>(reason)];
}

std::string rows_text(std::string_view word, const std::vector<LinkPair>& pairs) {
  if (pairs.empty()) return {};
  const auto name = [](int link) {
    return link == 0 ? std::string("\"base\"") : fmt::format("\"link {}\"", link);
  };
  std::string rows;
  for (const auto& [first, second] : pairs)
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", name(first), name(second));
  return fmt::format("    {}: [{}]\n", word, rows);
}

}  // namespace

Robot with_own_pairs(Robot robot, NamePairs allow, NamePairs watch) {
  if (!allow && !watch) return robot;
  RobotSpec spec = robot.spec();
  spec.allow = read_pairs(robot, "allow", allow);
  spec.watch = read_pairs(robot, "watch", watch);
  for (const LinkPair& each : spec.allow) {
    if (std::ranges::find(spec.watch, each) == spec.watch.end()) continue;
    throw ArgumentError(fmt::format("Robot `{}` allows and watches {}; name the pair once.",
                                    robot.name(), pair_text(robot, each)));
  }
  return Robot(std::move(spec));
}

std::string exempt_text(const Robot& robot) {
  const OwnPairs& own = robot.derived<OwnPairs>();
  std::string text;
  for (const ExemptReason reason : {ExemptReason::kAdjacent, ExemptReason::kSideBySide,
                                    ExemptReason::kOverlap, ExemptReason::kAllowed}) {
    std::string pairs;
    for (const ExemptPair& each : own.exempt()) {
      if (each.reason != reason) continue;
      pairs += fmt::format("{}{}", pairs.empty() ? "" : "; ", pair_text(robot, each.links));
      if (reason == ExemptReason::kOverlap) {
        // Rounded down, so that 100 % means all positions.
        const double percent = std::floor(1e3 * each.share) / 10.0;
        pairs += fmt::format(" (in {} % of {} random positions)", format_number(percent, 1),
                             OwnPairs::kPositions);
      }
      if (!each.whole) pairs += " (parts of them)";
    }
    if (!pairs.empty()) text += fmt::format("\n  {}: {}", reason_text(reason), pairs);
  }
  if (text.empty()) return {};
  return "links that are not compared with each other:" + text;
}

std::string own_pairs_rows(const Robot& robot) {
  return rows_text("allow", robot.spec().allow) + rows_text("watch", robot.spec().watch);
}

}  // namespace armlet::bind
