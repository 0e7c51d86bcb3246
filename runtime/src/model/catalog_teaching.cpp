// Small arms and arms for teaching.
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "catalog_rows.hpp"

namespace armlet::catalog {
namespace {

// clang-format off
// Three uniform rods of 2, 1.5 and 1 kg in the horizontal plane.
constexpr Row kPlanar3[] = {
    {R, {0, 0, 0.4, 0}, -170 * kDeg, 170 * kDeg, 0,
     2, {-0.2, 0, 0}, {0, 0.0266666666666667, 0.0266666666666667, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0.3, 0}, -150 * kDeg, 150 * kDeg, 0,
     1.5, {-0.15, 0, 0}, {0, 0.01125, 0.01125, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0.2, 0}, -150 * kDeg, 150 * kDeg, 0,
     1, {-0.1, 0, 0}, {0, 0.00333333333333333, 0.00333333333333333, 0, 0, 0}, 0, 1, {0, 0, 0}},
};

// Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, figure 3.6.
constexpr Row kPlanar2[] = {
    {R, {0, 0, 1, 0}, -180 * kDeg, 180 * kDeg, 0,
     1, {-0.5, 0, 0}, {0, 0, 0, 0, 0, 0}, 0, 0, {0, 0, 0}},
    {R, {0, 0, 1, 0}, -180 * kDeg, 180 * kDeg, 0,
     1, {-0.5, 0, 0}, {0, 0, 0, 0, 0, 0}, 0, 0, {0, 0, 0}},
};

// A generic elbow arm; the masses are invented but possible.
constexpr Row kRrr3[] = {
    {R, {0, 0.4, 0, 90 * kDeg}, -170 * kDeg, 170 * kDeg, 0,
     5, {0, -0.1, 0}, {0.06896, 0.055756, 0.072706, -0.002591, 2.5e-05, -0.006661},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0.45, 0}, -30 * kDeg, 200 * kDeg, 0,
     4, {-0.2, 0, 0.01}, {0.034668, 0.030418, 0.042479, 0.010517, -0.007335, 0.002162},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0.35, 0}, -150 * kDeg, 150 * kDeg, 0,
     2.5, {-0.17, 0.005, 0}, {0.044026, 0.032882, 0.039592, -0.001779, 0.002032, -0.011174},
     0, 1, {0, 0, 0}},
};

// A generic SCARA of 400 + 300 mm; the masses are invented but possible.
constexpr Row kScara[] = {
    {R, {0, 0.35, 0.4, 0}, -150 * kDeg, 150 * kDeg, 180 * kDeg,
     8, {-0.18, 0, 0.02}, {0.03, 0.11, 0.12, 0, 0.002, 0}, 0.00012, 80, {0.0003, 0.02, -0.02}},
    {R, {0, 0, 0.3, 180 * kDeg}, -140 * kDeg, 140 * kDeg, 240 * kDeg,
     5, {-0.13, 0.004, -0.03}, {0.015, 0.045, 0.05, 0.0005, 0, 0},
     8e-05, 60, {0.0002, 0.015, -0.02}},
    {P, {0, 0, 0, 0}, 0, 0.2, 0.5,
     1.5, {0, 0, -0.1}, {0.012, 0.012, 0.001, 0, 0, 0}, 3e-05, 120, {0.0001, 0.01, -0.01}},
    {R, {0, 0, 0, 0}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     0.6, {0, 0.002, 0.03}, {0.0008, 0.0008, 0.0003, 0, 0, 0}, 2e-05, 40, {0.0001, 0.004, -0.005}},
};

// DH rows and limits: ScorBotToolbox, US Naval Academy. Speeds: Intelitek user manual. The masses
// are invented but possible.
constexpr Row kScorbot[] = {
    {R, {0, 0.349, 0.016, 90 * kDeg}, -2.33466, 3.068393, 20 * kDeg,
     6, {0, -0.12, 0.01}, {0.109418, 0.093975, 0.108907, -0.004013, 0.001334, 0.005147},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0.221, 0}, -0.493562, 2.204281, 26.3 * kDeg,
     3.2, {-0.11, 0, 0.02}, {0.047651, 0.041573, 0.050506, 0.000814, -0.017709, 0.003498},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0.221, 0}, -2.45751, -0.09, 26.3 * kDeg,
     2.1, {-0.1, 0.01, 0}, {0.038577, 0.051976, 0.037974, -0.003207, -0.003722, 0.001562},
     0, 1, {0, 0, 0}},
    {R, {90 * kDeg, 0, 0, 90 * kDeg}, -1.91367, 2.34094, 83 * kDeg,
     0.7, {0, 0, 0.02}, {0.002077, 0.001591, 0.00209, -0.000115, -7.3e-05, -8.4e-05},
     0, 1, {0, 0, 0}},
    {R, {0, 0.145125, 0, 0}, -360 * kDeg, 360 * kDeg, 106 * kDeg,
     0.4, {0.001, -0.002, -0.05}, {0.000906, 0.000728, 0.000592, 0.000136, 2.6e-05, -0.000304},
     0, 1, {0, 0, 0}},
};

// A generic arm with a shoulder, an elbow and a wrist, without mass.
constexpr Row kArm7[] = {
    {.dh = {0, 0.34, 0, -90 * kDeg}, .lower = -170 * kDeg, .upper = 170 * kDeg},
    {.dh = {0, 0, 0, 90 * kDeg}, .lower = -120 * kDeg, .upper = 120 * kDeg},
    {.dh = {0, 0.4, 0, 90 * kDeg}, .lower = -170 * kDeg, .upper = 170 * kDeg},
    {.dh = {0, 0, 0, -90 * kDeg}, .lower = -120 * kDeg, .upper = 120 * kDeg},
    {.dh = {0, 0.4, 0, -90 * kDeg}, .lower = -170 * kDeg, .upper = 170 * kDeg},
    {.dh = {0, 0, 0, 90 * kDeg}, .lower = -120 * kDeg, .upper = 120 * kDeg},
    {.dh = {0, 0.126, 0, 0}, .lower = -170 * kDeg, .upper = 170 * kDeg},
};
// clang-format on

}  // namespace

std::span<const Arm> teaching_arms() {
  static const Arm arms[] = {
      {.name = "planar2",
       .second_name = "planar2r",
       .source = "Spong, Hutchinson, Vidyasagar, Robot Modeling and Control",
       .help = "Two links of 1 m in the vertical x-z plane.",
       .joints = kPlanar2,
       .home = {30, 60},
       .T_world_base = make_pose(rot_x(kPi / 2), Eigen::Vector3d::Zero())},
      {.name = "planar3",
       .second_name = "planar3r",
       .source = "generic planar arm of 400, 300 and 200 mm",
       .help = "Three links in the horizontal plane.",
       .joints = kPlanar3,
       .home = {30, 45, 30}},
      {.name = "anthropomorphic",
       .second_name = "rrr3",
       .source = "generic elbow arm",
       .help = "Three turning joints, without a wrist.",
       .joints = kRrr3,
       .home = {0, 60, -90}},
      {.name = "scara",
       .source = "generic SCARA of 400 and 300 mm",
       .help = "A SCARA with links of 400 and 300 mm and a 60 mm gripper; the tool points down.",
       .joints = kScara,
       .home = {0, 90, 0, 0},
       .stroke = 0.060},
      {.name = "scorbot",
       .second_name = "scorbot_er4u",
       .source = "ScorBotToolbox, US Naval Academy (Scorbot-ER 4U)",
       .help = "Scorbot-ER 4U, five joints.",
       .joints = kScorbot,
       .home = {0, 120.27, -95.03, -88.81, 0},
       .stroke = 0.060},
      {.name = "arm7",
       .source = "generic arm of seven joints, 340, 400, 400 and 126 mm",
       .help = "A generic arm of seven joints with a shoulder, an elbow and a wrist.",
       .joints = kArm7,
       .home = {0, 30, 0, -90, 0, 60, 0},
       .stroke = 0.060},
  };
  return arms;
}

}  // namespace armlet::catalog
