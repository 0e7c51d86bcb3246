// One step of visual servoing on one processor: the picture of a card by the camera on a
// seven-joint arm, 320 x 240 with 4 samples, light and shadow; its four corners by Harris, refined
// and matched to their labels; and the joint speeds with the motion that reaches them.
#include <array>
#include <cstdio>
#include <memory>
#include <numbers>

#include "armlet/camera/visual_servo.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/image/arithmetic.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/correspondence.hpp"
#include "bench.hpp"

namespace armlet::bench {
namespace {

constexpr double kPeriod = 0.04;

struct Hand {
  Cell cell;
  int robot, eye;
  Eigen::VectorXd q{{0.3, 0.6, 0.2, 1.3, -0.3, 1.0, 0.2}};
  Eigen::Isometry3d T_tool_camera = Eigen::Isometry3d::Identity();
  std::array<Eigen::Vector3d, 4> corners;
  Image picture{1, 1, PixelKind::kGrey};
  PlanePoints seen{4, 2};

  Hand() {
    robot = cell.add_robot(make_robot("pa10"), "arm");
    cell.set_joints(robot, q);
    T_tool_camera.translation().z() = 0.06;
    // The desk and the card are in front of the camera, whatever its direction.
    Camera camera{.name = "eye",
                  .on = {.base = FrameBase::kCarrier, .carrier = robot},
                  .T_on_camera = T_tool_camera};
    camera.lens = Pinhole(intrinsics_from_fov(320, 240, 55.0 * std::numbers::pi / 180.0));
    eye = cell.cameras().add(camera);
    T_tool_camera = cell.T_world_tool(robot).inverse() * cell.cameras().T_world_camera(cell, eye);
    const Eigen::Isometry3d T_world_card =
        cell.T_world_tool(robot) * T_tool_camera * Eigen::Translation3d(0.02, 0.01, 0.35);
    put("desk", {0.8, 0.8, 0.02}, T_world_card * Eigen::Translation3d(0, 0, 0.02), "seagreen");
    put("card", {0.12, 0.08, 0.005}, T_world_card, "white");
    for (int i = 0; i < 4; ++i)
      corners[static_cast<std::size_t>(i)] =
          T_world_card * Eigen::Vector3d(i % 3 == 0 ? -0.06 : 0.06, i < 2 ? -0.04 : 0.04, -0.0025);
    const Eigen::Isometry3d T_camera = cell.cameras().T_world_camera(cell, eye).inverse();
    for (int i = 0; i < 4; ++i)
      seen.row(i) = cell.cameras()
                        .at(eye)
                        .lens.project(T_camera * corners[static_cast<std::size_t>(i)])
                        .value()
                        .transpose();
  }
  void put(const char* name, const Eigen::Vector3d& size, const Eigen::Isometry3d& T,
           const char* color) {
    Object object;
    object.name = name;
    object.shape = Box{size};
    object.T_world_obj = T;
    object.fixed = true;
    object.color = color;
    cell.insert(object);
  }

  double draw() {
    picture = cell.cameras().color(cell, eye, cell.cameras().T_world_camera(cell, eye));
    return picture.row(0)[0];
  }
  PlanePoints found() const {
    constexpr double kGate = 12.0;
    const PlanePoints corners_near =
        find_corners_around(to_grey(picture), seen, 2.0 * kGate, {.method = CornerMethod::kHarris});
    const Matches matches = match_points(corners_near, seen, kGate);
    PlanePoints out(4, 2);
    for (int i = 0; i < 4; ++i) {
      const int row = matches.index[static_cast<std::size_t>(i)];
      if (row < 0) std::printf("corner %d is not found\n", i);
      out.row(i) = row < 0 ? seen.row(i) : corners_near.row(row);
    }
    return out;
  }
  // The motion of the next period, computed from the points.
  double control(VisualServo& servo, const PlanePoints& points, double t) const {
    Jacobian J;
    const Eigen::Isometry3d T = forward_and_jacobian(*cell.robot(robot).model, q, J);
    const Eigen::VectorXd qd =
        servo.look({.t = t,
                    .pixels = points,
                    .J_camera = camera_jacobian(J, T.linear(), T_tool_camera),
                    .q = q,
                    .qd = Eigen::VectorXd::Zero(7)});
    const VelocityPlan plan = plan_joint_velocity(
        *cell.robot(robot).model,
        {.q = q, .qd = Eigen::VectorXd::Zero(7), .qdd = {}, .during = kPeriod}, qd);
    return plan.motion ? plan.motion->duration() : 0.0;
  }
  VisualServo servo() {
    const Robot& model = *cell.robot(robot).model;
    ServoArm arm{.lower = Eigen::VectorXd(7),
                 .upper = Eigen::VectorXd(7),
                 .max_speed = Eigen::VectorXd(7),
                 .max_accel = Eigen::VectorXd(7),
                 .turns = std::vector<bool>(7, true)};
    for (int i = 0; i < 7; ++i) {
      arm.lower[i] = model.joint(i).lower;
      arm.upper[i] = model.joint(i).upper;
      arm.max_speed[i] = model.joint(i).max_speed;
      arm.max_accel[i] = model.joint(i).max_accel;
    }
    PlanePoints wanted = seen;
    wanted.rowwise() += Eigen::RowVector2d(20.0, -10.0);
    return VisualServo(cell.cameras().at(eye).lens,
                       {.wanted = wanted, .depths = Eigen::VectorXd::Constant(1, 0.35)}, arm,
                       {.timeout = 1e9});
  }
};

void print_part(const char* what, double nanoseconds, const char* target = "") {
  std::printf("%-40s %8.3f ms  %s\n", what, nanoseconds * 1e-6, target);
}

void time_step() {
  Hand hand;
  hand.draw();
  VisualServo servo = hand.servo();
  const PlanePoints points = hand.found();
  const auto draw = [&](int) { return hand.draw(); };
  const auto find = [&](int) { return hand.found()(0, 0); };
  const auto control = [&](int) { return hand.control(servo, points, 0.0); };
  const auto step = [&](int) {
    hand.draw();
    return hand.control(servo, hand.found(), 0.0);
  };
  const Times whole = compare(Calls(10), step, draw);
  const Times parts = compare(Calls(10), find, control);
  print_part("a step of visual servoing, 320 x 240", whole.ours, "(target: 6 ms)");
  print_part("  the picture, 4 samples and shadow", whole.theirs);
  print_part("  four corners by Harris", parts.ours);
  print_part("  joint speeds and the motion", parts.theirs);
  if (servo.end() != ServoEnd::kNone) std::printf("ended: %s\n", servo.why().c_str());
}

}  // namespace
}  // namespace armlet::bench

int main() {
  armlet::bench::time_step();
  return 0;
}
