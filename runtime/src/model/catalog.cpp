#include "armlet/model/catalog.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>

#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

constexpr double kDeg = kPi / 180.0;
constexpr JointKind R = JointKind::kRevolute;
constexpr JointKind P = JointKind::kPrismatic;

// A joint and its link. The inertia is about the centre of mass: xx, yy, zz, xy, xz, yz.
struct Row {
  JointKind kind;
  DhRow dh;
  double lower, upper, max_speed;
  double mass;
  std::array<double, 3> com;
  std::array<double, 6> inertia;
  double motor_inertia, gear;
  Friction friction;
};

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

// P. Corke and B. Armstrong-Helouvry, A search for consensus among model parameters reported for
// the PUMA 560 robot, ICRA 1994; limits and pedestal as in the Robotics Toolbox. Speeds: maker.
constexpr Row kPuma560[] = {
    {R, {0, 0.67183, 0, 90 * kDeg}, -160 * kDeg, 160 * kDeg, 82 * kDeg,
     0, {0, 0, 0}, {0, 0.35, 0, 0, 0, 0}, 0.0002, -62.6111, {0.00148, 0.395, -0.435}},
    {R, {0, 0, 0.4318, 0}, -110 * kDeg, 110 * kDeg, 54 * kDeg,
     17.4, {-0.3638, 0.006, 0.2275}, {0.13, 0.524, 0.539, 0, 0, 0},
     0.0002, 107.815, {0.000817, 0.126, -0.071}},
    {R, {0, 0.15005, 0.0203, -90 * kDeg}, -135 * kDeg, 135 * kDeg, 122 * kDeg,
     4.8, {-0.0203, -0.0141, 0.07}, {0.066, 0.086, 0.0125, 0, 0, 0},
     0.0002, -53.7063, {0.00138, 0.132, -0.105}},
    {R, {0, 0.4318, 0, 90 * kDeg}, -266 * kDeg, 266 * kDeg, 228 * kDeg,
     0.82, {0, 0.019, 0}, {0.0018, 0.0013, 0.0018, 0, 0, 0},
     3.3e-05, 76.0364, {7.12e-05, 0.0112, -0.0169}},
    {R, {0, 0, 0, -90 * kDeg}, -100 * kDeg, 100 * kDeg, 241 * kDeg,
     0.34, {0, 0, 0}, {0.0003, 0.0004, 0.0003, 0, 0, 0},
     3.3e-05, 71.923, {8.26e-05, 0.00926, -0.0145}},
    {R, {0, 0, 0, 0}, -266 * kDeg, 266 * kDeg, 228 * kDeg,
     0.09, {0, 0, 0.032}, {0.00015, 0.00015, 4e-05, 0, 0, 0},
     3.3e-05, 76.686, {3.67e-05, 0.00396, -0.0105}},
};

// R. Paul, Robot Manipulators, MIT Press 1981, tables 6.5 and 6.6.
constexpr Row kStanford[] = {
    {R, {0, 0.412, 0, -90 * kDeg}, -170 * kDeg, 170 * kDeg, 0,
     9.29, {0, 0.0175, -0.1105}, {0.276, 0.255, 0.071, 0, 0, 0}, 0.953, 1, {0, 0, 0}},
    {R, {0, 0.154, 0, 90 * kDeg}, -170 * kDeg, 170 * kDeg, 0,
     5.01, {0, -0.1054, 0}, {0.108, 0.018, 0.1, 0, 0, 0}, 2.193, 1, {0, 0, 0}},
    {P, {-90 * kDeg, 0, 0.0203, 0}, 0.3048, 1.27, 0,
     4.25, {0, 0, -0.6447}, {2.51, 2.51, 0.006, 0, 0, 0}, 0.782, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -170 * kDeg, 170 * kDeg, 0,
     1.08, {0, 0.0092, -0.0054}, {0.002, 0.001, 0.001, 0, 0, 0}, 0.106, 1, {0, 0, 0}},
    {R, {0, 0, 0, 90 * kDeg}, -90 * kDeg, 90 * kDeg, 0,
     0.63, {0, 0.0566, 0.0003}, {0.003, 0.0004, 0, 0, 0, 0}, 0.097, 1, {0, 0, 0}},
    {R, {0, 0, 0, 0}, -170 * kDeg, 170 * kDeg, 0,
     0.51, {0, 0, 0.1554}, {0.013, 0.013, 0.0003, 0, 0, 0}, 0.02, 1, {0, 0, 0}},
};

// DH rows and limits: ARTE toolbox, Miguel Hernandez University. Speeds: maker. The masses are
// invented but possible.
constexpr Row kPa10Six[] = {
    {R, {0, 0.315, 0, 90 * kDeg}, -177 * kDeg, 177 * kDeg, 57 * kDeg,
     9, {0, -0.05, 0.02}, {0.119772, 0.098544, 0.12482, -0.012417, 0.000982, 0.007893},
     0, 1, {0, 0, 0}},
    {R, {90 * kDeg, 0, 0.45, 0}, -91 * kDeg, 91 * kDeg, 57 * kDeg,
     11, {-0.2, 0.01, 0.03}, {0.165024, 0.29002, 0.250736, 0.031151, -0.027433, -0.034767},
     0, 1, {0, 0, 0}},
    {R, {90 * kDeg, 0, 0, 90 * kDeg}, -137 * kDeg, 137 * kDeg, 114 * kDeg,
     6.5, {0.01, -0.02, 0.06}, {0.040857, 0.034497, 0.048268, 0.008817, 0.006413, 0.000198},
     0, 1, {0, 0, 0}},
    {R, {0, 0.5, 0, -90 * kDeg}, -255 * kDeg, 255 * kDeg, 360 * kDeg,
     4, {0, 0.12, 0.01}, {0.024863, 0.023784, 0.021847, -0.000442, 0.000892, -0.000614},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0, 90 * kDeg}, -165 * kDeg, 165 * kDeg, 360 * kDeg,
     2.5, {0, 0.004, 0.03}, {0.013267, 0.013066, 0.012307, -0.0001, 0.000433, 0.000114},
     0, 1, {0, 0, 0}},
    {R, {0, 0.08, 0, 0}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     1, {0, 0, -0.03}, {0.004308, 0.003753, 0.003374, 0.000555, 0.000355, 0.000257},
     0, 1, {0, 0, 0}},
};

// DH rows: OpenBionics, modelMitsubishiPA10. Limits and speeds: maker. The masses are invented but
// possible.
constexpr Row kPa10[] = {
    {R, {0, 0.317, 0, 0}, -177 * kDeg, 177 * kDeg, 57 * kDeg,
     9.8, {0, -0.016, -0.166}, {0.100133, 0.117502, 0.096676, -0.025287, -0.005892, 0.022759},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -91 * kDeg, 91 * kDeg, 57 * kDeg,
     8.4, {0, -0.063, 0}, {0.130747, 0.135791, 0.132324, -0.001113, -0.006032, 0.015201},
     0, 1, {0, 0, 0}},
    {R, {0, 0.45, 0, 90 * kDeg}, -174 * kDeg, 174 * kDeg, 114 * kDeg,
     4.8, {0, 0.015, -0.21}, {0.078296, 0.07596, 0.074801, 0.000189, 0.000314, -0.002492},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -137 * kDeg, 137 * kDeg, 114 * kDeg,
     4.2, {0, -0.11, 0}, {0.067391, 0.069157, 0.059913, -0.002782, 0.001267, 0.001929},
     0, 1, {0, 0, 0}},
    {R, {0, 0.48, 0, 90 * kDeg}, -255 * kDeg, 255 * kDeg, 360 * kDeg,
     3.5, {0, 0.01, -0.18}, {0.042823, 0.02984, 0.043387, 0.001772, 0.006505, 0.004247},
     0, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -165 * kDeg, 165 * kDeg, 360 * kDeg,
     2, {0, -0.01, 0.01}, {0.023651, 0.025409, 0.019652, 0.006111, 0.001821, 0.002476},
     0, 1, {0, 0, 0}},
    {R, {0, 0.07, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 360 * kDeg,
     1.2, {0, 0, -0.02}, {0.0207, 0.020517, 0.02082, -0.00041, -0.000587, -0.000299},
     0, 1, {0, 0, 0}},
};

// DH rows, masses and centres: Universal Robots support article. Inertias: solid cylinders with the
// radii and lengths of the ROS-Industrial description.
constexpr Row kUr5[] = {
    {R, {0, 0.089159, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     3.7, {0, -0.02561, 0.00193}, {0.014972358, 0.01040625, 0.014972358, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0, -0.425, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     8.393, {0.2125, 0, 0.11336}, {0.0151074, 0.133885835, 0.133885835, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0, -0.39225, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     2.33, {0.15, 0, 0.0265}, {0.004194, 0.031971495, 0.031971495, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0.10915, 0, 90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     1.219, {0, -0.0018, 0.01634}, {0.00201389, 0.0021942, 0.00201389, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0.09465, 0, -90 * kDeg}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     1.219, {0, -0.0018, 0.01634}, {0.00183104, 0.0021942, 0.00183104, 0, 0, 0}, 0, 1, {0, 0, 0}},
    {R, {0, 0.0823, 0, 0}, -360 * kDeg, 360 * kDeg, 180 * kDeg,
     0.1897, {0, 0, -0.001159}, {8.1397e-05, 8.1397e-05, 0.000133383, 0, 0, 0}, 0, 1, {0, 0, 0}},
};

// DH rows: Franka Emika; dynamics: C. Gaz et al., IEEE Robotics and Automation Letters 4(4), 2019,
// with centres of mass moved to the DH frames.
constexpr Row kPanda[] = {
    {R, {0, 0.333, 0, 0}, -2.8973, 2.8973, 124.6 * kDeg,
     4.970684, {0.003875, 0.002081, -0.175},
     {0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -1.7628, 1.7628, 124.6 * kDeg,
     0.646926, {-0.003141, -0.02872, 0.003495},
     {0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704}, 0, 1, {0, 0, 0}},
    {R, {0, 0.316, 0, 90 * kDeg}, -2.8973, 2.8973, 124.6 * kDeg,
     3.228604, {0.027518, 0.039252, -0.066502},
     {0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0.0825, 90 * kDeg}, -3.0718, -0.0698, 124.6 * kDeg,
     3.587895, {-0.05317, 0.104419, 0.027454},
     {0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641}, 0, 1, {0, 0, 0}},
    {R, {0, 0.384, -0.0825, -90 * kDeg}, -2.8973, 2.8973, 149.5 * kDeg,
     1.225946, {-0.011953, 0.041065, -0.038437},
     {0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0, 90 * kDeg}, -0.0175, 3.7525, 149.5 * kDeg,
     1.666555, {0.060149, -0.014117, -0.010517},
     {0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341}, 0, 1, {0, 0, 0}},
    {R, {0, 0.107, 0.088, 90 * kDeg}, -2.8973, 2.8973, 149.5 * kDeg,
     0.735522, {0.010517, -0.004252, -0.045403},
     {0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741}, 0, 1, {0, 0, 0}},
};

// clang-format on

struct Description {
  const char* name;
  const char* source;
  DhConvention convention = DhConvention::kStandard;
  InertiaCheck inertia_check = InertiaCheck::kRigidBody;
  std::vector<double> home;  // deg for turning joints, m for sliding ones
  double stroke = 0.0;       // of the gripper, m; 0: no hand
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_flange_tool = Eigen::Isometry3d::Identity();
};

Link make_link(const Row& row) {
  const auto& [xx, yy, zz, xy, xz, yz] = row.inertia;
  Link link;
  link.mass = row.mass;
  link.com = Eigen::Vector3d(row.com[0], row.com[1], row.com[2]);
  link.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  link.motor_inertia = row.motor_inertia;
  link.gear = row.gear;
  link.friction = row.friction;
  return link;
}

Robot make_arm(std::span<const Row> rows, const Description& description) {
  RobotSpec spec;
  spec.name = description.name;
  spec.source = description.source;
  spec.convention = description.convention;
  spec.inertia_check = description.inertia_check;
  spec.T_world_base = description.T_world_base;
  spec.T_flange_tool = description.T_flange_tool;
  if (description.stroke > 0.0) spec.tool = parallel_gripper(description.stroke, 0.0);
  spec.home.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    spec.joints.push_back({.kind = row.kind,
                           .dh = row.dh,
                           .lower = row.lower,
                           .upper = row.upper,
                           .max_speed = row.max_speed});
    spec.links.push_back(make_link(row));
    spec.home[static_cast<Eigen::Index>(i)] =
        row.kind == R ? deg_to_rad(description.home[i]) : description.home[i];
  }
  return Robot(std::move(spec));
}

}  // namespace

Robot make_planar2() {
  return make_arm(kPlanar2, {.name = "planar2",
                             .source = "Spong, Hutchinson, Vidyasagar, Robot Modeling and Control",
                             .home = {30, 60},
                             .T_world_base = make_pose(rot_x(kPi / 2), Eigen::Vector3d::Zero())});
}

Robot make_planar3() {
  return make_arm(kPlanar3, {.name = "planar3",
                             .source = "generic planar arm of 400, 300 and 200 mm",
                             .home = {30, 45, 30}});
}

Robot make_rrr3() {
  return make_arm(kRrr3, {.name = "rrr3", .source = "generic elbow arm", .home = {0, 60, -90}});
}

Robot make_scara() {
  return make_arm(kScara, {.name = "scara",
                           .source = "generic SCARA of 400 and 300 mm",
                           .home = {0, 90, 0, 0},
                           .stroke = 0.060});
}

Robot make_scorbot() {
  return make_arm(kScorbot, {.name = "scorbot",
                             .source = "ScorBotToolbox, US Naval Academy (Scorbot-ER 4U)",
                             .home = {0, 120.27, -95.03, -88.81, 0},
                             .stroke = 0.060});
}

Robot make_puma560() {
  return make_arm(kPuma560, {.name = "puma560",
                             .source = "Corke and Armstrong-Helouvry 1994",
                             .inertia_check = InertiaCheck::kPublished,
                             .home = {0, -45, -50, 0, -85, 0},
                             .stroke = 0.060});
}

Robot make_stanford() {
  return make_arm(kStanford, {.name = "stanford",
                              .source = "Paul 1981, tables 6.5 and 6.6",
                              .inertia_check = InertiaCheck::kPublished,
                              .home = {0, 105, 0.5, -90, -75, 0},
                              .stroke = 0.060});
}

Robot make_pa10_6() {
  return make_arm(kPa10Six, {.name = "pa10_6",
                             .source = "ARTE toolbox, Miguel Hernandez University",
                             .home = {0, 30, 60, 0, 90, 0},
                             .stroke = 0.060});
}

Robot make_pa10() {
  return make_arm(kPa10, {.name = "pa10",
                          .source = "OpenBionics, modelMitsubishiPA10",
                          .convention = DhConvention::kModified,
                          .home = {0, 30, 0, 90, 0, 60, 0},
                          .stroke = 0.060});
}

Robot make_ur5() {
  return make_arm(kUr5, {.name = "ur5",
                         .source = "Universal Robots support article",
                         .home = {0, -90, -90, -90, 90, 0},
                         .stroke = 0.085});
}

Robot make_panda() {
  const Eigen::Isometry3d T_flange_tool = make_pose(rot_z(-kPi / 4), {0.0, 0.0, 0.103});
  return make_arm(kPanda, {.name = "panda",
                           .source = "Franka Emika; Gaz et al. 2019",
                           .convention = DhConvention::kModified,
                           .inertia_check = InertiaCheck::kPublished,
                           .home = {0, -45, 0, -135, 0, 90, 45},
                           .stroke = 0.080,
                           .T_flange_tool = T_flange_tool});
}

namespace {

struct Entry {
  std::string_view name;
  Robot (*make)();
};

constexpr Entry kEntries[] = {
    {"planar2", make_planar2},   {"planar3", make_planar3}, {"rrr3", make_rrr3},
    {"scara", make_scara},       {"scorbot", make_scorbot}, {"puma560", make_puma560},
    {"stanford", make_stanford}, {"pa10_6", make_pa10_6},   {"pa10", make_pa10},
    {"ur5", make_ur5},           {"panda", make_panda}};

}  // namespace

const std::vector<std::string_view>& catalog_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Entry& entry : kEntries) list.push_back(entry.name);
    return list;
  }();
  return names;
}

std::shared_ptr<const Robot> make_robot(std::string_view name) {
  if (name == "anthropomorphic") name = "rrr3";
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return std::make_shared<const Robot>(entry.make());
  }
  return nullptr;
}

}  // namespace armlet
