// The units of lists with a number for each joint, or with the velocity of the tool point.

#include <fmt/format.h>

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "armlet/interpreter/unit.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

using Dims = std::vector<NumberDim>;

// Reads the units from the known robot, now or when the enclosing function is called with one.
void note_of_robot(CheckCall& call, const DimsOfArgumentFact::Reader& reader) {
  constexpr int kRobot = 0;
  const auto robot =
      call.given(CallPart::first()) ? call.fact(CallPart::first()) : call.ambient_fact("robot");
  if (robot == nullptr)
    return call.set_result_fact(std::make_shared<DimsOfArgumentFact>(kRobot, reader));
  if (Dims dims = reader(*robot); !dims.empty())
    call.set_result_fact(std::make_shared<DimsFact>(std::move(dims)));
}

void note_by_joint(CheckCall& call, Dim turning, Dim sliding) {
  note_of_robot(call, [turning, sliding](const Fact& of_robot) {
    Dims dims;
    if (const auto* robot = dynamic_cast<const RobotFact*>(&of_robot)) {
      for (const bool turns : robot->turns) dims.push_back({turns ? turning : sliding});
    } else if (const auto* read = dynamic_cast<const ReadRobotFact*>(&of_robot)) {
      dims.push_back({.later = dims_by_joint(si_unit(turning), si_unit(sliding), read->name)});
    }
    return dims;
  });
}

void note_six(CheckCall& call, Dim along, Dim about) {
  call.set_result_fact(
      std::make_shared<DimsFact>(Dims{{along}, {along}, {along}, {about}, {about}, {about}}));
}

}  // namespace

std::string dims_by_joint(std::string_view turning, std::string_view sliding,
                          std::string_view robot) {
  return fmt::format("{}|{}|{}", turning, sliding, robot);
}

void note_positions(CheckCall& call) { note_by_joint(call, dims::kAngle, dims::kLength); }
void note_same_numbers(CheckCall& call) {
  const DimsOfArgumentFact::Reader reader = [](const Fact& given) {
    const auto* known = dynamic_cast<const DimsFact*>(&given);
    return known != nullptr ? known->dims : Dims();
  };
  const auto given = call.fact(CallPart::first());
  if (given == nullptr)
    return call.set_result_fact(std::make_shared<DimsOfArgumentFact>(0, reader));
  if (Dims dims = reader(*given); !dims.empty())
    call.set_result_fact(std::make_shared<DimsFact>(std::move(dims)));
}
void note_speeds(CheckCall& call) { note_by_joint(call, dims::kAngularSpeed, dims::kSpeed); }
void note_accels(CheckCall& call) { note_by_joint(call, dims::kAngularAccel, dims::kAccel); }
void note_forces(CheckCall& call) { note_by_joint(call, dims::kTorque, dims::kForce); }
void note_dh_table(CheckCall& call) {
  note_of_robot(call, [](const Fact& of_robot) {
    Dims dims;
    const auto* robot = dynamic_cast<const RobotFact*>(&of_robot);
    for (std::size_t i = 0; robot != nullptr && i < robot->turns.size(); ++i)
      dims.insert(dims.end(), {{dims::kAngle}, {dims::kLength}, {dims::kLength}, {dims::kAngle}});
    return dims;
  });
}
void note_twist(CheckCall& call) { note_six(call, dims::kSpeed, dims::kAngularSpeed); }
void note_twist_rate(CheckCall& call) { note_six(call, dims::kAccel, dims::kAngularAccel); }

// urdf(path, tip, inertias, base, tool, name)
void note_read_robot(CheckCall& call) {
  const auto name = call.constant(at("name"));
  if (!name || name->text.empty() || name->text.find(',') != std::string::npos) return;
  auto fact = std::make_shared<ReadRobotFact>();
  fact->name = name->text;
  call.set_result_fact(std::move(fact));
}

}  // namespace armlet::bind
