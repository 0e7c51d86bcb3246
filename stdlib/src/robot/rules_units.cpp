// The units of lists that have a number for each joint, or those of a velocity of the tool point.

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "robot/rules.hpp"

namespace armlet::bind {
namespace {

void note_dims(CheckCall& call, std::vector<Dim> dims) {
  call.set_result_fact(std::make_shared<DimsFact>(std::move(dims)));
}

void note_by_joint(CheckCall& call, Dim turning, Dim sliding) {
  const auto robot = robot_of(call);
  if (robot == nullptr) return;
  std::vector<Dim> dims;
  for (const bool turns : robot->turns) dims.push_back(turns ? turning : sliding);
  note_dims(call, std::move(dims));
}

void note_six(CheckCall& call, Dim along, Dim about) {
  note_dims(call, {along, along, along, about, about, about});
}

}  // namespace

void note_positions(CheckCall& call) { note_by_joint(call, dims::kAngle, dims::kLength); }
void note_speeds(CheckCall& call) { note_by_joint(call, dims::kAngularSpeed, dims::kSpeed); }
void note_accels(CheckCall& call) { note_by_joint(call, dims::kAngularAccel, dims::kAccel); }
void note_forces(CheckCall& call) { note_by_joint(call, dims::kTorque, dims::kForce); }
void note_dh_table(CheckCall& call) {
  const auto robot = robot_of(call);
  if (robot == nullptr) return;
  std::vector<Dim> dims;
  for (std::size_t i = 0; i < robot->turns.size(); ++i)
    dims.insert(dims.end(), {dims::kAngle, dims::kLength, dims::kLength, dims::kAngle});
  note_dims(call, std::move(dims));
}
void note_twist(CheckCall& call) { note_six(call, dims::kSpeed, dims::kAngularSpeed); }
void note_twist_rate(CheckCall& call) { note_six(call, dims::kAccel, dims::kAngularAccel); }

}  // namespace armlet::bind
