// A checked move without the language: torques and collisions are looked at before it starts.
#include <armlet/control/make_move.hpp>
#include <armlet/model/catalog.hpp>
#include <iostream>

namespace {

// A move to the left, at half the speed, and what has become of it.
void move_left(armlet::Cell& cell, int arm) {
  const Eigen::VectorXd q = Eigen::Vector4d(1.0, 0.6, 0.0, 0.0);
  armlet::MoveCommand command{.robot = arm, .target = armlet::JointTarget{q}, .speed = 0.5};
  command.policies = {.torques = armlet::TorqueCheck::kError,
                      .collisions = armlet::CollisionCheck::kError};
  const armlet::MoveReport report = armlet::make_move(cell, armlet::PlannerSet(), command);
  if (!report.ok()) {
    std::cout << armlet::to_text(cell, report) << '\n';
    return;
  }
  cell.advance_to(cell.report(report.motion).end_ns);
  std::cout << "There at t = " << armlet::to_seconds(cell.now_ns()) << " s.\n";
}

}  // namespace

int main() {
  armlet::Cell cell;
  const int arm = cell.add_robot(armlet::make_robot("scara"), "arm");
  move_left(cell, arm);
  armlet::Object post{.name = "post", .shape = armlet::Box{{0.05, 0.05, 1.0}}, .fixed = true};
  post.T_world_obj.translation() = Eigen::Vector3d(0.67, 0.0, 0.5);
  cell.insert(std::move(post));
  cell.set_joints(arm, Eigen::Vector4d(-1.0, 0.6, 0.0, 0.0));
  move_left(cell, arm);
}

// Prints:
// There at t = 1.19366 s.
// link 3 of `arm` and "post" would collide 1.001 s after the start, 27.4 mm deep.
