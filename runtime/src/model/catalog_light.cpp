// Light arms that work next to people.
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "catalog_rows.hpp"

namespace armlet {
namespace {

using namespace catalog;

// clang-format off
// As the UR5: Universal Robots support article and the cylinders of the ROS-Industrial description.
constexpr Row kUr3[] = {
    {R, {0, 0.1519, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     2, {0, -0.02, 0}, {0.00809316667, 0.005625, 0.00809316667, 0, 0, 0}, 0, 1, {0, 0, 0}, 56},
    {R, {0, 0, -0.24365, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     3.42, {0.13, 0, 0.1157}, {0.00961875, 0.0217284919, 0.0217284919, 0, 0, 0}, 0, 1, {0, 0, 0}, 56},
    {R, {0, 0, -0.21325, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     1.26, {0.05, 0, 0.0238}, {0.00354375, 0.00654680906, 0.00654680906, 0, 0, 0}, 0, 1, {0, 0, 0}, 28},
    {R, {0, 0.11235, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     0.8, {0, 0, 0.01}, {0.002085, 0.00225, 0.002085, 0, 0, 0}, 0, 1, {0, 0, 0}, 12},
    {R, {0, 0.08535, 0, -90 * kDeg}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     0.8, {0, 0, 0.01}, {0.002085, 0.00225, 0.002085, 0, 0, 0}, 0, 1, {0, 0, 0}, 12},
    {R, {0, 0.0819, 0, 0}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     0.35, {0, 0, -0.02}, {0.000136266667, 0.000136266667, 0.0001792, 0, 0, 0}, 0, 1, {0, 0, 0}, 12},
};

// DH rows, masses and centres: Universal Robots support article. Inertias: solid cylinders with the
// radii and lengths of the ROS-Industrial description. Efforts: Universal Robots, Max. joint torques.
constexpr Row kUr5[] = {
    {R, {0, 0.089159, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     3.7, {0, -0.02561, 0.00193}, {0.014972358, 0.01040625, 0.014972358, 0, 0, 0}, 0, 1, {0, 0, 0}, 150},
    {R, {0, 0, -0.425, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     8.393, {0.2125, 0, 0.11336}, {0.0151074, 0.133885835, 0.133885835, 0, 0, 0}, 0, 1, {0, 0, 0}, 150},
    {R, {0, 0, -0.39225, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     2.33, {0.15, 0, 0.0265}, {0.004194, 0.031971495, 0.031971495, 0, 0, 0}, 0, 1, {0, 0, 0}, 150},
    {R, {0, 0.10915, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     1.219, {0, -0.0018, 0.01634}, {0.00201389, 0.0021942, 0.00201389, 0, 0, 0}, 0, 1, {0, 0, 0}, 28},
    {R, {0, 0.09465, 0, -90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     1.219, {0, -0.0018, 0.01634}, {0.00183104, 0.0021942, 0.00183104, 0, 0, 0}, 0, 1, {0, 0, 0}, 28},
    {R, {0, 0.0823, 0, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     0.1897, {0, 0, -0.001159}, {8.1397e-05, 8.1397e-05, 0.000133383, 0, 0, 0}, 0, 1, {0, 0, 0}, 28},
};

constexpr Row kUr10[] = {
    {R, {0, 0.1273, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 120 * kDeg,
     7.1, {0.021, 0, 0.027}, {0.0287307417, 0.01996875, 0.0287307417, 0, 0, 0}, 0, 1, {0, 0, 0}, 330},
    {R, {0, 0, -0.612, 0}, -360 * kDeg, 360 * kDeg, 120 * kDeg,
     12.7, {0.38, 0, 0.158}, {0.03571875, 0.414251775, 0.414251775, 0, 0, 0}, 0, 1, {0, 0, 0}, 330},
    {R, {0, 0, -0.5723, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     4.27, {0.24, 0, 0.068}, {0.012009375, 0.122549815, 0.122549815, 0, 0, 0}, 0, 1, {0, 0, 0}, 150},
    {R, {0, 0.163941, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     2, {0, 0.007, 0.018}, {0.0052125, 0.005625, 0.0052125, 0, 0, 0}, 0, 1, {0, 0, 0}, 56},
    {R, {0, 0.1157, 0, -90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     2, {0, 0.007, 0.018}, {0.0052125, 0.005625, 0.0052125, 0, 0, 0}, 0, 1, {0, 0, 0}, 56},
    {R, {0, 0.0922, 0, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     0.365, {0, 0, -0.026}, {0.000213076354, 0.000213076354, 0.0003695625, 0, 0, 0}, 0, 1, {0, 0, 0}, 56},
};

// DH rows: Franka Emika; dynamics: C. Gaz et al., IEEE Robotics and Automation Letters 4(4), 2019,
// with centres of mass moved to the DH frames. Rates and efforts: Franka Control Interface.
constexpr Row kPanda[] = {
    {R, {0, 0.333, 0, 0}, -2.8973, 2.8973, 124.6 * kDeg,
     4.970684, {0.003875, 0.002081, -0.175},
     {0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169}, 0, 1, {0, 0, 0}, 87, {15, 7500}},
    {R, {0, 0, 0, -90 * kDeg}, -1.7628, 1.7628, 124.6 * kDeg,
     0.646926, {-0.003141, -0.02872, 0.003495},
     {0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704}, 0, 1, {0, 0, 0}, 87, {7.5, 3750}},
    {R, {0, 0.316, 0, 90 * kDeg}, -2.8973, 2.8973, 124.6 * kDeg,
     3.228604, {0.027518, 0.039252, -0.066502},
     {0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805}, 0, 1, {0, 0, 0}, 87, {10, 5000}},
    {R, {0, 0, 0.0825, 90 * kDeg}, -3.0718, -0.0698, 124.6 * kDeg,
     3.587895, {-0.05317, 0.104419, 0.027454},
     {0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641}, 0, 1, {0, 0, 0}, 87, {12.5, 6250}},
    {R, {0, 0.384, -0.0825, -90 * kDeg}, -2.8973, 2.8973, 149.5 * kDeg,
     1.225946, {-0.011953, 0.041065, -0.038437},
     {0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229}, 0, 1, {0, 0, 0}, 12, {15, 7500}},
    {R, {0, 0, 0, 90 * kDeg}, -0.0175, 3.7525, 149.5 * kDeg,
     1.666555, {0.060149, -0.014117, -0.010517},
     {0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341}, 0, 1, {0, 0, 0}, 12, {20, 10000}},
    {R, {0, 0.107, 0.088, 90 * kDeg}, -2.8973, 2.8973, 149.5 * kDeg,
     0.735522, {0.010517, -0.004252, -0.045403},
     {0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741}, 0, 1, {0, 0, 0}, 12, {20, 10000}},
};

// KUKA LBR iiwa 14 R820. Limits, speeds and efforts: maker. Masses, centres and inertias: iiwa_stack, moved to
// the DH frames.
constexpr Row kIiwa[] = {
    {R, {0, 0.36, 0, 0}, -170 * kDeg, 170 * kDeg, 85 * kDeg,
     4, {0, -0.03, -0.0825}, {0.1, 0.09, 0.02, 0, 0, 0}, 0, 1, {0, 0, 0}, 320},
    {R, {0, 0, 0, -90 * kDeg}, -120 * kDeg, 120 * kDeg, 85 * kDeg,
     4, {-0.0003, -0.059, 0.042}, {0.05, 0.018, 0.044, 0, 0, 0}, 0, 1, {0, 0, 0}, 320},
    {R, {0, 0.42, 0, 90 * kDeg}, -170 * kDeg, 170 * kDeg, 100 * kDeg,
     3, {0, 0.03, -0.0855}, {0.08, 0.075, 0.01, 0, 0, 0}, 0, 1, {0, 0, 0}, 176},
    {R, {0, 0, 0, 90 * kDeg}, -120 * kDeg, 120 * kDeg, 75 * kDeg,
     2.7, {0, 0.067, 0.034}, {0.03, 0.01, 0.029, 0, 0, 0}, 0, 1, {0, 0, 0}, 176},
    {R, {0, 0.4, 0, -90 * kDeg}, -170 * kDeg, 170 * kDeg, 130 * kDeg,
     1.7, {-0.0001, -0.021, -0.1395}, {0.02, 0.018, 0.005, 0, 0, 0}, 0, 1, {0, 0, 0}, 110},
    {R, {0, 0, 0, -90 * kDeg}, -120 * kDeg, 120 * kDeg, 135 * kDeg,
     1.8, {0, -0.0006, 0.0004}, {0.005, 0.0036, 0.0047, 0, 0, 0}, 0, 1, {0, 0, 0}, 40},
    {R, {0, 0.126, 0, 90 * kDeg}, -175 * kDeg, 175 * kDeg, 135 * kDeg,
     0.3, {0, 0, -0.025}, {0.001, 0.001, 0.001, 0, 0, 0}, 0, 1, {0, 0, 0}, 40},
};
// clang-format on

}  // namespace

std::span<const Arm> catalog::light_arms() {
  static const Arm arms[] = {
      {.name = "ur3",
       .source = "Universal Robots support article",
       .help = "Universal Robots UR3, six joints.",
       .joints = kUr3,
       .home = {0, -90, -90, -90, 90, 0},
       .stroke = 0.085},
      {.name = "ur5",
       .source = "Universal Robots support article",
       .help = "Universal Robots UR5, six joints.",
       .joints = kUr5,
       .home = {0, -90, -90, -90, 90, 0},
       .stroke = 0.085},
      {.name = "ur10",
       .source = "Universal Robots support article",
       .help = "Universal Robots UR10, six joints.",
       .joints = kUr10,
       .home = {0, -90, -90, -90, 90, 0},
       .stroke = 0.085},
      {.name = "panda",
       .source = "Franka Emika; Gaz et al. 2019",
       .help = "Franka Emika Panda, seven joints.",
       .joints = kPanda,
       .convention = DhConvention::kModified,
       .inertia_check = InertiaCheck::kPublished,
       .home = {0, -45, 0, -135, 0, 90, 45},
       .stroke = 0.080,
       .T_flange_tool = make_pose(rot_z(-kPi / 4), {0.0, 0.0, 0.103})},
      {.name = "iiwa14",
       .second_name = "iiwa",
       .source = "KUKA LBR iiwa 14 R820; iiwa_stack",
       .help = "KUKA LBR iiwa 14 R820, seven joints.",
       .joints = kIiwa,
       .convention = DhConvention::kModified,
       .home = {0, 30, 0, -90, 0, 60, 0},
       .stroke = 0.060},
  };
  return arms;
}

}  // namespace armlet
