// Robots and their parts: what is known of them from the text, and mistakes in it.

#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"

namespace armlet::bind {

void set_robot_fact(CheckCall& call, std::shared_ptr<const Robot> robot, std::string name,
                    std::initializer_list<CallPart> may_tilt) {
  auto fact = std::make_shared<RobotFact>();
  fact->name = std::move(name);
  for (int i = 0; i < robot->n(); ++i) {
    fact->turns.push_back(robot->is_revolute(i));
    fact->limits.push_back(std::array{robot->lower()[i], robot->upper()[i]});
  }
  fact->model = std::move(robot);
  fact->may_be_tilted = may_be_tilted(call, may_tilt);
  call.set_result_fact(std::move(fact));
}

namespace {

// (theta, d, a, alpha, limits, ...)
void set_joint_fact(CheckCall& call, bool turns) {
  constexpr CallPart kRow[] = {at("theta"), at("d"), at("a"), at("alpha")};
  auto fact = std::make_shared<JointFact>();
  fact->turns = turns;
  std::array<double, std::size(kRow)> row{};
  bool known = true;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto value = call.given(kRow[i]) ? call.constant(kRow[i]) : Constant{};
    known = known && value;
    if (value) row[i] = value->real;
  }
  if (known) fact->row = DhRow{row[0], row[1], row[2], row[3]};
  const auto limits = call.constant(at("limits"));
  if (limits && limits->kind == Constant::Kind::kList && limits->items.size() == 2) {
    fact->limits = {limits->items[0].real, limits->items[1].real};
    fact->written = call.span(at("limits"));
  }
  call.set_result_fact(std::move(fact));
}

// E0511, for joint number `i` from 0.
void check_limits(CheckCall& call, const JointFact& joint, int i) {
  if (!joint.limits || (*joint.limits)[0] <= (*joint.limits)[1]) return;
  const JointKind kind = joint.turns ? JointKind::kRevolute : JointKind::kPrismatic;
  Diagnostic d =
      make_diagnostic(row("E0511"), joint.written,
                      {format_joint_value(kind, (*joint.limits)[0]), std::to_string(i + 1),
                       format_joint_value(kind, (*joint.limits)[1])});
  d.fix = Fix{.text = "limits are written as [lower, upper]"};
  const std::string text = call.text_of(joint.written);
  const std::size_t comma = text.find(',');
  const bool is_pair = text.starts_with('[') && text.ends_with(']') && comma != std::string::npos &&
                       comma == text.rfind(',') && text[comma + 1] == ' ';
  if (is_pair) {
    const std::string upper = text.substr(comma + 2, text.size() - comma - 3);
    const std::string swapped = '[' + upper + ", " + text.substr(1, comma - 1) + ']';
    d.fix = Fix{.text = "write " + swapped, .edits = {{joint.written, swapped}}};
  }
  call.report(std::move(d));
}

}  // namespace

void check_revolute_row(CheckCall& call) {
  check_inertia_size(call, at("inertia"));
  set_joint_fact(call, true);
}
void check_prismatic_row(CheckCall& call) {
  check_inertia_size(call, at("inertia"));
  set_joint_fact(call, false);
}

// (name: string, joint: jointRow[], base, tool, gravity, convention, home, tcp, ...)
void check_robot_block(CheckCall& call) {
  std::vector<Joint> joints;
  auto fact = std::make_shared<RobotFact>();
  if (const auto name = call.constant(at("name"))) fact->name = name->text;
  for (int i = 0; i < call.item_count(at("joint")); ++i) {
    const auto joint = std::dynamic_pointer_cast<const JointFact>(call.item_fact(at("joint"), i));
    if (joint == nullptr) return;
    check_limits(call, *joint, i);
    fact->turns.push_back(joint->turns);
    fact->limits.push_back(joint->limits);
    if (joint->row) joints.push_back(joint_of(*joint));
  }
  if (fact->turns.empty()) {
    Diagnostic d = make_diagnostic(row("E0508"), call.callee_span(), {fact->name});
    d.fix = Fix{.text = "give it joints, such as joint revolute(a: 300mm)"};
    return call.report(std::move(d));
  }
  const auto home = call.given(at("home"))
                        ? std::dynamic_pointer_cast<const PositionFact>(call.fact(at("home")))
                        : nullptr;
  if (home != nullptr) check_joint_values(call, *fact, *home, call.span(at("home")));
  const auto convention =
      call.given(at("convention")) ? call.constant(at("convention")) : Constant{};
  if (convention && joints.size() == fact->turns.size()) {
    note_model(call, *fact, joints,
               convention->text == "modified" ? DhConvention::kModified : DhConvention::kStandard,
               {at("base"), at("tool"), at("tcp")});
  }
  call.set_result_fact(std::move(fact));
}

// robots.NAME(base, tool, name)
void check_ready_robot(CheckCall& call) {
  const std::string_view function = call.function_name();
  const auto robot = make_robot(function.substr(function.rfind('.') + 1));
  const auto name = call.constant(at("name"));
  // A base in the call replaces that of the catalogue.
  auto placed = call.given(at("base"))
                    ? std::make_shared<const Robot>(robot->with_base(Eigen::Isometry3d::Identity()))
                    : robot;
  set_robot_fact(call, std::move(placed), name ? name->text : robot->name(),
                 {at("base"), at("tool")});
}

void check_default_robot(CheckCall& call) {
  const auto* host = static_cast<const Host*>(call.host());
  if (host == nullptr) return;
  if (const auto robot = host->default_robot_model()) {
    set_robot_fact(call, robot, robot->name());
  } else if (!call.callee_span().empty()) {  // a call, not a query about one
    call.report(make_diagnostic("E0220", call.callee_span(), {"robot"}));
  }
}

}  // namespace armlet::bind
