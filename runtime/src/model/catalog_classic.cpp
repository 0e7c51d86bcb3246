// Arms of laboratories and workshops.
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "catalog_rows.hpp"

namespace armlet::catalog {
namespace {

// clang-format off
// P. Corke and B. Armstrong-Helouvry, A search for consensus among model parameters reported for
// the PUMA 560 robot, ICRA 1994; limits and pedestal as in the Robotics Toolbox. Speeds: maker.
// Efforts: B. Armstrong, O. Khatib and J. Burdick, ICRA 1986.
constexpr Row kPuma560[] = {
    {R, {0, 0.67183, 0, 90 * kDeg}, -160 * kDeg, 160 * kDeg, 82 * kDeg,
     0, {0, 0, 0}, {0, 0.35, 0, 0, 0, 0}, 0.0002, -62.6111, {0.00148, 0.395, -0.435}, 97.6},
    {R, {0, 0, 0.4318, 0}, -110 * kDeg, 110 * kDeg, 54 * kDeg,
     17.4, {-0.3638, 0.006, 0.2275}, {0.13, 0.524, 0.539, 0, 0, 0},
     0.0002, 107.815, {0.000817, 0.126, -0.071}, 186.4},
    {R, {0, 0.15005, 0.0203, -90 * kDeg}, -135 * kDeg, 135 * kDeg, 122 * kDeg,
     4.8, {-0.0203, -0.0141, 0.07}, {0.066, 0.086, 0.0125, 0, 0, 0},
     0.0002, -53.7063, {0.00138, 0.132, -0.105}, 89.4},
    {R, {0, 0.4318, 0, 90 * kDeg}, -266 * kDeg, 266 * kDeg, 228 * kDeg,
     0.82, {0, 0.019, 0}, {0.0018, 0.0013, 0.0018, 0, 0, 0},
     3.3e-05, 76.0364, {7.12e-05, 0.0112, -0.0169}, 24.2},
    {R, {0, 0, 0, -90 * kDeg}, -100 * kDeg, 100 * kDeg, 241 * kDeg,
     0.34, {0, 0, 0}, {0.0003, 0.0004, 0.0003, 0, 0, 0},
     3.3e-05, 71.923, {8.26e-05, 0.00926, -0.0145}, 20.1},
    {R, {0, 0, 0, 0}, -266 * kDeg, 266 * kDeg, 228 * kDeg,
     0.09, {0, 0, 0.032}, {0.00015, 0.00015, 4e-05, 0, 0, 0},
     3.3e-05, 76.686, {3.67e-05, 0.00396, -0.0105}, 21.3},
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

// ABB IRB 120-3/0.6. Limits and speeds: maker. Masses, centres and inertias: ROS-Industrial, moved to the DH
// frames.
constexpr Row kIrb120[] = {
    {R, {0, 0.29, 0, -90 * kDeg}, -165 * kDeg, 165 * kDeg, 250 * kDeg,
     3.067, {9.77e-05, 0.05159, -0.00012},
     {0.0142175, 0.0104533, 0.0144041, 2.31364e-05, -1.28579e-05, -1.93404e-05}, 0, 1, {0, 0, 0}},
    {R, {-90 * kDeg, 0, 0.27, 0}, -110 * kDeg, 110 * kDeg, 250 * kDeg,
     3.909, {-0.16876, 0.00078, -0.00212},
     {0.0259548, 0.0603111, 0.041569, 5.72407e-05, -0.00050497, 9.83431e-06}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0.07, -90 * kDeg}, -110 * kDeg, 70 * kDeg, 250 * kDeg,
     2.944, {-0.01209, -0.00106, 0.02281},
     {0.0126984, 0.016713, 0.00835606, 0.000182227, 0.00142884, 8.01545e-05}, 0, 1, {0, 0, 0}},
    {R, {0, 0.302, 0, 90 * kDeg}, -160 * kDeg, 160 * kDeg, 320 * kDeg,
     1.328, {0.00041, -0.0773, 0.00015},
     {0.0052535, 0.00284661, 0.00401346, -1.6435e-05, 1.31336e-05, -2.12765e-05}, 0, 1, {0, 0, 0}},
    {R, {0, 0, 0, -90 * kDeg}, -120 * kDeg, 120 * kDeg, 320 * kDeg,
     0.546, {6.22e-05, -3.68e-05, -0.00109},
     {0.000815468, 0.000892825, 0.000404891, 1.5179e-08, 8.46805e-07, -1.61943e-06}, 0, 1, {0, 0, 0}},
    {R, {180 * kDeg, 0.072, 0, 0}, -400 * kDeg, 400 * kDeg, 420 * kDeg,
     0.137, {1.32e-06, -0.00017, -0.00706}, {0.001, 0.001, 0.001, 0, 0, 0}, 0, 1, {0, 0, 0}},
};

// KUKA KR 6 R900 sixx (Agilus). Dimensions, limits and speeds: maker, as in kuka_experimental of
// ROS-Industrial. Joints 2, 3 and 5 have the maker's sign; 1, 4 and 6 the opposite one, with
// symmetric limits.
constexpr Row kKr6[] = {
    {.dh = {0, 0.4, 0.025, -90 * kDeg}, .lower = -170 * kDeg, .upper = 170 * kDeg, .max_speed = 360 * kDeg},
    {.dh = {0, 0, 0.455, 0}, .lower = -190 * kDeg, .upper = 45 * kDeg, .max_speed = 300 * kDeg},
    {.dh = {-90 * kDeg, 0, 0.035, -90 * kDeg}, .lower = -120 * kDeg, .upper = 156 * kDeg, .max_speed = 360 * kDeg},
    {.dh = {0, 0.42, 0, 90 * kDeg}, .lower = -185 * kDeg, .upper = 185 * kDeg, .max_speed = 381 * kDeg},
    {.dh = {0, 0, 0, -90 * kDeg}, .lower = -120 * kDeg, .upper = 120 * kDeg, .max_speed = 388 * kDeg},
    {.dh = {180 * kDeg, 0.08, 0, 0}, .lower = -350 * kDeg, .upper = 350 * kDeg, .max_speed = 615 * kDeg},
};
// clang-format on

}  // namespace

std::span<const Arm> workshop_arms() {
  static const Arm arms[] = {
      {.name = "puma560",
       .source = "Corke and Armstrong-Helouvry 1994",
       .help = "Unimation Puma 560, six joints.",
       .joints = kPuma560,
       .inertia_check = InertiaCheck::kPublished,
       .home = {0, -45, -50, 0, -85, 0},
       .stroke = 0.060},
      {.name = "stanford",
       .source = "Paul 1981, tables 6.5 and 6.6",
       .help = "Stanford arm, six joints, the third slides.",
       .joints = kStanford,
       .inertia_check = InertiaCheck::kPublished,
       .home = {0, 105, 0.5, -90, -75, 0},
       .stroke = 0.060},
      {.name = "pa10_6",
       .source = "ARTE toolbox, Miguel Hernandez University",
       .help = "Mitsubishi PA-10 with six joints.",
       .joints = kPa10Six,
       .home = {0, 30, 60, 0, 90, 0},
       .stroke = 0.060},
      {.name = "pa10",
       .second_name = "pa10_7",
       .source = "OpenBionics, modelMitsubishiPA10",
       .help = "Mitsubishi PA-10 with seven joints.",
       .joints = kPa10,
       .convention = DhConvention::kModified,
       .home = {0, 30, 0, 90, 0, 60, 0},
       .stroke = 0.060},
      {.name = "irb120",
       .second_name = "abb_irb120",
       .source = "ABB product specification IRB 120; ROS-Industrial",
       .help = "ABB IRB 120, six joints.",
       .joints = kIrb120,
       .home = {0, 20, 10, 0, 60, 0},
       .stroke = 0.060},
      {.name = "kr6",
       .second_name = "kr6r900sixx",
       .source = "KUKA KR AGILUS sixx specification; ROS-Industrial",
       .help = "KUKA KR 6 R900 sixx (Agilus), six joints.",
       .joints = kKr6,
       .home = {0, -90, 90, 0, 90, 0},
       .stroke = 0.060},
  };
  return arms;
}

}  // namespace armlet::catalog
