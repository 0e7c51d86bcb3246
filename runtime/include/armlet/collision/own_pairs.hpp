// The pairs of bodies of an arm that are checked for self-collision, and why other pairs are
// exempt.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/collision/arm_solids.hpp"

namespace armlet {

// kAdjacent    a joint is between the two links, or a chain of links without bodies. For bodies
//              made from a joint table: joints on one axis.
// kOverlap     they overlap in nearly all random configurations.
// kSideBySide  both are made from a table, and only joints of parallel axes are between them: the
//              table does not say whether they lie side by side.
// kAllowed     RobotSpec::allow names them.
enum class ExemptReason { kAdjacent, kOverlap, kSideBySide, kAllowed };

// share  of the random configurations in which they overlap, 0 to 1, of kOverlap alone.
// whole  whether no body of one link is compared with a body of the other.
struct ExemptPair {
  LinkPair links;
  ExemptReason reason = ExemptReason::kAdjacent;
  double share = 0.0;
  bool whole = true;
};

// Computed once for an arm, before its first motion: `robot.derived<OwnPairs>()`. A pair of links
// is exempt only if it is adjacent or overlaps in at least kNearlyAll of kPositions random
// configurations within the limits, always the same ones. RobotSpec::watch names pairs that are
// always compared. Bodies from a table, which are coarser than the arm, are exempted individually.
//
// source  I. A. Sucan, S. Chitta, the rule of the set-up assistant of MoveIt: "adjacent" and
//         "always" pairs of links.
class OwnPairs {
 public:
  using FromShape = void;
  static constexpr int kPositions = 10'000;
  static constexpr double kNearlyAll = 0.95;

  explicit OwnPairs(const Robot& robot);

  // Pairs of ArmSolids::slim for which a motion has to be checked, first.frame > second.frame.
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }

  // Sorted by links and reason. Links without bodies are in no pair.
  [[nodiscard]] const std::vector<ExemptPair>& exempt() const { return exempt_; }

 private:
  std::vector<std::pair<int, int>> pairs_;
  std::vector<ExemptPair> exempt_;
};

// "the base", or "link 3"; with the name of the description, if there is one.
std::string link_text(const Robot& robot, int link);

// The link of that name: "base", "link 3", or a name of the description, also of a link that is
// fixed to another one.
//
// returns  0: the base; i: the link that joint i moves; -1: there is none.
int link_of_name(const Robot& robot, std::string_view name);

}  // namespace armlet
