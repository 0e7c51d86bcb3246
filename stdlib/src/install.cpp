#include "armlet/stdlib/install.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "armlet/interpreter/later.hpp"
#include "bind.hpp"
#include "values.hpp"

namespace armlet {
namespace {

constexpr NativeConstant kConstants[] = {
    {"PI", std::numbers::pi, dims::kNone, "The circumference of a circle over its diameter."},
    {"E", std::numbers::e, dims::kNone, "The base of natural logarithms."},
};

// Names of the language reference without even a signature yet.
constexpr std::string_view kPlanned[] = {"simulate", "mesh", "lab",
                                         // settings of with
                                         "with.collisions"};

}  // namespace

namespace bind {

std::span<const Chapter> chapters() {
  static const Chapter all[] = {
      {"Mathematics", math_functions()},
      {"Lists", list_functions()},
      {"Vectors", vector_functions()},
      {"Matrices", matrix_functions()},
      {"Matrices: parts", matrix_part_functions()},
      {"Linear algebra", linalg_functions()},
      {"Fits, roots and equations", numeric_functions()},
      {"Differential equations", ode_functions()},
      {"Text", text_functions()},
      {"Positions and frames", pose_functions()},
      {"Positions and frames: orientations", rotation_functions()},
      {"Robots: models", model_functions()},
      {"Robots: tables", dh_functions()},
      {"Robots: state and kinematics", robot_functions()},
      {"Robots: inverse kinematics", ikine_functions()},
      {"Robots: inverse kinematics as values", ikine_info_functions()},
      {"Robots: motion", motion_functions()},
      {"Robots: velocity commands", velocity_functions()},
      {"Trajectories", trajectory_functions()},
      {"Trajectories: integration", acceleration_functions()},
      {"Trajectories: planners", planner_functions()},
      {"Robots: settings", settings_functions()},
      {"Robots: paths", path_functions()},
      {"Hands", hand_functions()},
      {"World and signals", world_functions()},
      {"The classic subset", classic_functions()},
      {"Time", time_functions()},
      {"Tables", table_functions()},
      {"Figures", plot_functions()},
      {"Figures: several lines", plot_line_functions()},
      {"Figures: motions and records", plot_motion_functions()},
      {"Later", later_functions()},
  };
  return all;
}

}  // namespace bind

void install(Engine& engine) {
  for (const HostType* type :
       {&bind::kPosJ, &bind::kPosC, &bind::kRobot, &bind::kObject, &bind::kShape, &bind::kTool,
        &bind::kJointRow, &bind::kCamera, &bind::kImage, &bind::kTrajectory, &bind::kFinger}) {
    engine.add_type(*type);
  }
  engine.add_record("Lu", "L: matrix, U: matrix, P: matrix");
  engine.add_record("Qr", "Q: matrix, R: matrix");
  engine.add_record("Svd", "U: matrix, s: double[], V: matrix");
  engine.add_record("Eig", "values: double[], vectors: matrix");
  engine.add_record("Eigenvalues", "re: double[], im: double[]");
  engine.add_record("Move",
                    "reached: bool, stopped: bool, time: time, length: length, deviation: length");
  engine.add_record("IkInfo",
                    "found: bool, q: posJ, method: string, branch: string, iterations: int, "
                    "residual: length, tilt: angle, distance: length, nearest: posC, worstJoint: "
                    "int, margin: double[]");
  engine.add_record("Wrench", "x: force, y: force, z: force, mx: torque, my: torque, mz: torque");
  engine.add_record("GraspQuality",
                    "contacts: int, minSingular: double, volume: double, forceClosure: bool");
  engine.add_record("Blob", "x: double, y: double, area: double");
  engine.add_record("Match", "x: double, y: double, score: double");
  engine.add_record("OdeSolution", "t: time[], y: matrix");
  engine.add_constants(kConstants, "Mathematics");
  engine.add_planned(kPlanned);
  for (const bind::Chapter& chapter : bind::chapters())
    engine.add_functions(chapter.functions, chapter.title);
}

std::vector<std::string> later_features() {
  std::vector<std::string> features;
  const auto add = [&features](std::string feature) {
    if (std::ranges::find(features, feature) == features.end())
      features.push_back(std::move(feature));
  };
  for (const bind::Chapter& chapter : bind::chapters()) {
    for (const NativeFunction& function : chapter.functions) {
      if (function.later) add(later_feature(function));
    }
  }
  for (const std::string_view name : kPlanned) {
    const std::size_t dot = name.find('.');
    add(dot == std::string_view::npos ? fmt::format("`{}`", name)
                                      : fmt::format("the setting `{}`", name.substr(dot + 1)));
  }
  for (const std::string_view feature : kLaterInLanguage) add(std::string(feature));
  return features;
}

}  // namespace armlet
