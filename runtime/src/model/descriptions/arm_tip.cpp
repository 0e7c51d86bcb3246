#include "arm_tip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace armlet {
namespace {

// The moving bodies of a mechanism as a tree.
class Tree {
 public:
  explicit Tree(const Mechanism& mechanism) : m_(mechanism) {
    const std::size_t count = m_.bodies().size();
    children_.resize(count + 1);
    below_.assign(count, false);
    joints_.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const int body = static_cast<int>(i);
      const int parent = m_.bodies()[i].parent;
      children_[static_cast<std::size_t>(parent + 1)].push_back(body);
      joints_[i] = (parent < 0 ? 0 : joints(parent)) + (moves(body) ? 1 : 0);
    }
    for (std::size_t i = count; i-- > 0;) {
      if (moves(static_cast<int>(i))) below_[i] = true;
      const int parent = m_.bodies()[i].parent;
      if (below_[i] && parent >= 0) below_[static_cast<std::size_t>(parent)] = true;
    }
  }

  bool moves(int body) const { return m_.joint_of(body) >= 0; }
  const std::vector<int>& children(int body) const {
    return children_[static_cast<std::size_t>(body + 1)];
  }
  // Number of joints between the base and a body.
  int joints(int body) const { return body < 0 ? 0 : joints_[static_cast<std::size_t>(body)]; }

  // The children that move or carry moving bodies.
  std::vector<int> moving_children(int body) const {
    std::vector<int> moving;
    for (const int child : children(body)) {
      if (below_[static_cast<std::size_t>(child)]) moving.push_back(child);
    }
    return moving;
  }

  bool is_on_path(int body, int end) const {
    while (end > body) end = m_.bodies()[static_cast<std::size_t>(end)].parent;
    return end == body;
  }

  // Whether a joint is a mimic joint.
  bool copies(int body) const {
    const int joint = m_.joint_of(body);
    const Eigen::MatrixXd& C = m_.spec().coupling;
    int drivers = 0;
    Eigen::Index driver = -1;
    for (Eigen::Index a = 0; a < C.cols(); ++a) {
      if (C(joint, a) == 0.0) continue;
      ++drivers;
      driver = a;
    }
    if (drivers != 1) return true;
    // A joint with its own motor has the motor's name, or the motor drives no earlier joint.
    const std::string& motor = m_.actuators()[static_cast<std::size_t>(driver)].name;
    const std::string& own = m_.bodies()[static_cast<std::size_t>(body)].joint_name;
    if (motor == own) return false;
    for (const int other : m_.moving()) {
      if (m_.bodies()[static_cast<std::size_t>(other)].joint_name == motor) return true;
    }
    for (int j = 0; j < joint; ++j) {
      if (C(j, driver) != 0.0) return true;
    }
    return false;
  }

  // Follows links that are fixed to a body, as long as there is only one, or one whose name says
  // that a tool belongs there.
  int end_of_fixed(int body) const {
    constexpr std::string_view kTools[] = {"tool0", "tcp", "tool", "ee", "flange"};
    for (;;) {
      const std::vector<int>& all = children(body);
      int next = all.size() == 1 ? all[0] : -1;
      for (const std::string_view name : kTools) {
        for (const int child : all) {
          if (next < 0 && m_.bodies()[static_cast<std::size_t>(child)].name == name) next = child;
        }
      }
      if (next < 0 || !moving_children(body).empty()) return body;
      body = next;
    }
  }

 private:
  const Mechanism& m_;
  std::vector<std::vector<int>> children_;  // of the base first
  std::vector<bool> below_;                 // whether it moves or carries moving bodies
  std::vector<int> joints_;
};

const std::string& name_of(const Mechanism& m, int body) {
  return body < 0 ? m.spec().base_name : m.bodies()[static_cast<std::size_t>(body)].name;
}

// "`tool0` (3 joints: j1, j2, j3)"
std::string described(const Mechanism& m, const Tree& tree, int body) {
  constexpr std::size_t kMostJoints = 12;
  std::vector<std::string_view> joints;
  for (int at = body; at >= 0; at = m.bodies()[static_cast<std::size_t>(at)].parent) {
    if (tree.moves(at)) joints.push_back(m.bodies()[static_cast<std::size_t>(at)].joint_name);
  }
  std::ranges::reverse(joints);
  const std::size_t count = joints.size();
  if (count > kMostJoints) joints.resize(kMostJoints);
  return fmt::format("`{}` ({} joint{}{}{}{})", name_of(m, body), count, count == 1 ? "" : "s",
                     joints.empty() ? "" : ": ", fmt::join(joints, ", "),
                     count > kMostJoints ? " ..." : "");
}

Error no_chain(const Mechanism& m, const std::string& reason) {
  const Tree tree(m);
  std::string leaves;
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    if (!tree.children(static_cast<int>(i)).empty()) continue;
    leaves += (leaves.empty() ? "" : ", ") + m.bodies()[i].name;
  }
  return {"no_chain",
          fmt::format("{}; name the link at the end of the arm: one of {}", reason, leaves)};
}

// The last moving bodies of all chains beyond a body.
std::vector<int> ends_beyond(const Mechanism& m, const Tree& tree, int body) {
  std::vector<int> ends;
  for (const int moving : m.moving()) {
    if (tree.is_on_path(body, moving) && tree.moving_children(moving).empty())
      ends.push_back(moving);
  }
  return ends;
}

// The end of the longest chain, if the others have no motor.
std::optional<int> longest(const Mechanism& m, const Tree& tree, const std::vector<int>& ends) {
  const auto shorter = [&](int a, int b) { return tree.joints(a) < tree.joints(b); };
  const int best = *std::ranges::max_element(ends, shorter);
  for (const int end : ends) {
    if (end != best && tree.joints(end) == tree.joints(best)) return std::nullopt;
  }
  for (const int body : m.moving()) {
    if (tree.copies(body) == tree.is_on_path(body, best)) return std::nullopt;
  }
  return best;
}

Error undecided(const Mechanism& m, const Tree& tree, int body, const std::vector<int>& ends) {
  constexpr std::size_t kMostNamed = 10;
  std::vector<std::string> named;
  for (const int end : ends) {
    if (named.size() < kMostNamed) named.push_back(described(m, tree, tree.end_of_fixed(end)));
  }
  if (tree.joints(body) > 0) named.push_back(described(m, tree, body) + ", where they meet");
  if (ends.size() > kMostNamed) named.push_back(fmt::format("{} more", ends.size() - kMostNamed));
  return {"no_chain",
          fmt::format("`{}` has several arms: they divide at the link `{}` and end at {}; name the "
                      "link at the end of the arm, tip: \"{}\" in a program, --tip {} in the "
                      "command",
                      m.name(), name_of(m, body), fmt::join(named, ", "),
                      name_of(m, tree.end_of_fixed(ends.front())),
                      name_of(m, tree.end_of_fixed(ends.front())))};
}

Result<ArmTip> default_tip(const Mechanism& m) {
  const Tree tree(m);
  if (m.moving().empty())
    return no_chain(m, fmt::format("`{}` has no joint that turns or slides", m.name()));
  int at = -1;
  for (;;) {
    const std::vector<int> moving = tree.moving_children(at);
    if (moving.empty()) return ArmTip{.body = tree.end_of_fixed(at)};
    if (moving.size() > 1) break;
    at = moving[0];
  }
  const std::vector<int> ends = ends_beyond(m, tree, at);
  const std::optional<int> best = longest(m, tree, ends);
  if (!best) return undecided(m, tree, at, ends);
  const int tip = tree.end_of_fixed(*best);
  return ArmTip{
      .body = tip,
      .note = fmt::format("the arm ends at {}, the longest chain from `{}`; the joints beside it "
                          "copy others; tip: \"{}\" says so",
                          described(m, tree, tip), name_of(m, at), name_of(m, tip))};
}

}  // namespace

Result<ArmTip> find_arm_tip(const Mechanism& m, std::string_view name) {
  if (name.empty()) return default_tip(m);
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    if (m.bodies()[i].name == name) return ArmTip{.body = static_cast<int>(i)};
  }
  for (const Tip& tip : m.tips()) {
    if (tip.name == name) return ArmTip{.body = tip.body, .T_body_tip = tip.T_body_tip};
  }
  return no_chain(m, fmt::format("`{}` has no link `{}`", m.name(), name));
}

}  // namespace armlet
