// Robots from tables, checked before the run: E0509, E0510, E0511, and limits that were assumed
// (W0716).

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/model/joint_limits.hpp"
#include "armlet/model/robot.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

std::string count_of(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

bool is_list(const std::optional<Constant>& value) {
  return value && value->kind == Constant::Kind::kList;
}

// "RRPR" from a word or from one text for each joint; nullopt if it is not known from the text.
std::optional<std::string> kinds_of(const CheckCall& call) {
  const auto types = call.constant(at("types"));
  if (!types) return std::nullopt;
  if (types->kind == Constant::Kind::kText) return types->text;
  std::string word;
  for (const Constant& letter : types->items) word += letter.text;
  return word;
}

// E0509; false if a row was reported.
bool check_rows(CheckCall& call, const Constant& table) {
  constexpr std::size_t kRow = 4;
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const std::size_t found = table.items[i].items.size();
    if (table.items[i].kind != Constant::Kind::kList || found == kRow) continue;
    Diagnostic d = make_diagnostic(row("E0509"), call.item_span(at("table"), static_cast<int>(i)),
                                   {std::to_string(i + 1), count_of(found, "value")});
    d.why = "a row is theta, d, a, alpha";
    call.report(std::move(d));
    return false;
  }
  return true;
}

// E0511; false if a pair was reported.
bool check_limits(CheckCall& call, const std::string& kinds) {
  const auto limits = call.constant(at("limits"));
  if (!is_list(limits)) return true;
  for (std::size_t i = 0; i < limits->items.size() && i < kinds.size(); ++i) {
    const auto& pair = limits->items[i].items;
    if (pair.size() != 2 || pair[0].real <= pair[1].real) continue;
    const JointKind kind = kinds[i] == 'R' ? JointKind::kRevolute : JointKind::kPrismatic;
    Diagnostic d = make_diagnostic(row("E0511"), call.item_span(at("limits"), static_cast<int>(i)),
                                   {format_joint_value(kind, pair[0].real), std::to_string(i + 1),
                                    format_joint_value(kind, pair[1].real)});
    d.fix = Fix{.text = "limits are written as [lower, upper]"};
    call.report(std::move(d));
    return false;
  }
  return true;
}

// W0716: limits that were assumed.
void report_assumed_limits(CheckCall& call, const std::string& kinds) {
  const auto text_of = [](JointKind kind) {
    const Joint joint = joint_without_limits(kind);
    return fmt::format("{} to {}", format_joint_value(kind, joint.lower),
                       format_joint_value(kind, joint.upper));
  };
  const bool turns = kinds.find('R') != std::string::npos;
  const bool slides = kinds.find('P') != std::string::npos;
  std::string assumed;
  if (turns) assumed += fmt::format("joints that turn go from {}", text_of(JointKind::kRevolute));
  if (slides) {
    assumed += fmt::format("{} from {}", turns ? ", those that slide" : "joints that slide go",
                           text_of(JointKind::kPrismatic));
  }
  Diagnostic d = make_diagnostic(row("W0716"), call.callee_span(), {assumed});
  d.fix = Fix{.text = "give them: limits: [[-2.6, 2.6], ...], in rad and m"};
  call.report(std::move(d));
}

// Notes the model of a robot from a table, if the whole table is known from the text.
void note_table_model(CheckCall& call, const std::string& kinds, RobotFact& fact) try {
  const auto table = call.constant(at("table"));
  const auto convention =
      call.given(at("convention")) ? call.constant(at("convention")) : Constant{};
  if (!is_list(table) || !convention) return;
  std::vector<std::vector<double>> rows;
  for (const Constant& line : table->items) {
    rows.emplace_back();
    for (const Constant& value : line.items) rows.back().push_back(value.real);
  }
  note_model(call, fact, joints_from_table(rows, kinds),
             convention->text == "modified" ? DhConvention::kModified : DhConvention::kStandard,
             {at("base"), at("tool")});
} catch (const ArgumentError&) {
  // A table that makes no robot is reported in the run, with the reason.
}

}  // namespace

void check_dh_table(CheckCall& call) {
  const auto table = call.constant(at("table"));
  if (is_list(table) && !check_rows(call, *table)) return;
  const auto kinds = kinds_of(call);
  if (!kinds) {
    if (!call.given(at("limits"))) report_assumed_limits(call, "RP");
    return;
  }
  const bool letters = kinds->find_first_not_of("RP") == std::string::npos;
  if (!letters || (is_list(table) && kinds->size() != table->items.size())) {
    Diagnostic d = make_diagnostic(row("E0510"), call.span(at("types")), {*kinds});
    if (letters)
      d.mark.label = fmt::format("{} for {}", count_of(kinds->size(), "joint"),
                                 count_of(table->items.size(), "row"));
    d.why = "R is a joint that turns, P one that slides";
    return call.report(std::move(d));
  }
  if (!call.given(at("limits"))) {
    report_assumed_limits(call, *kinds);
  } else if (!check_limits(call, *kinds)) {
    return;
  }
  auto fact = std::make_shared<RobotFact>();
  const auto name = call.constant(at("name"));
  fact->name = name ? name->text : "this robot";
  for (const char c : *kinds) fact->turns.push_back(c == 'R');
  const auto limits = call.given(at("limits")) ? call.constant(at("limits")) : std::nullopt;
  for (std::size_t i = 0; is_list(limits) && i < limits->items.size(); ++i) {
    const auto& pair = limits->items[i].items;
    fact->limits.emplace_back();
    if (pair.size() == 2) fact->limits.back() = {pair[0].real, pair[1].real};
  }
  note_table_model(call, *kinds, *fact);
  call.set_result_fact(std::move(fact));
}

}  // namespace armlet::bind
