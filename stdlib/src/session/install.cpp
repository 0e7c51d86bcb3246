#include "armlet/stdlib/install.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "armlet/interpreter/later.hpp"
#include "laboratory/lab_values.hpp"
#include "messages/foreign_names.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet {
namespace {

constexpr NativeConstant kConstants[] = {
    {"PI", std::numbers::pi, dims::kNone, "The circumference of a circle over its diameter."},
    {"E", std::numbers::e, dims::kNone, "The base of natural logarithms."},
};

// Names of the language reference without even a signature yet.
constexpr std::string_view kPlanned[] = {"mesh",
                                         // settings of with
                                         "with.collisions"};

}  // namespace

namespace bind {

std::span<const Chapter> chapters() {
  static const Chapter all[] = {
      {.title = "Mathematics", .functions = math_functions(), .is_mathematics = true},
      {.title = "Lists", .functions = list_functions()},
      {.title = "Vectors", .functions = vector_functions(), .is_mathematics = true},
      {.title = "Matrices", .functions = matrix_functions(), .is_mathematics = true},
      {.title = "Matrices: parts", .functions = matrix_part_functions(), .is_mathematics = true},
      {.title = "Linear algebra", .functions = linalg_functions(), .is_mathematics = true},
      {.title = "Fits, roots and equations",
       .functions = numeric_functions(),
       .is_mathematics = true},
      {.title = "Differential equations", .functions = ode_functions(), .is_mathematics = true},
      {.title = "Text", .functions = text_functions()},
      {.title = "Positions and frames", .functions = pose_functions(), .is_mathematics = true},
      {.title = "Positions and frames: orientations",
       .functions = rotation_functions(),
       .is_mathematics = true},
      {.title = "Robots: models", .functions = model_functions(), .is_mathematics = true},
      {.title = "Robots: tables", .functions = dh_functions(), .is_mathematics = true},
      {.title = "Robots: state and kinematics",
       .functions = robot_functions(),
       .is_mathematics = true},
      {.title = "Robots: inverse kinematics",
       .functions = ikine_functions(),
       .is_mathematics = true},
      {.title = "Robots: inverse kinematics as values",
       .functions = ikine_info_functions(),
       .is_mathematics = true},
      {.title = "Robots: dynamics", .functions = dynamics_functions(), .is_mathematics = true},
      {.title = "Robots: simulation", .functions = simulation_functions(), .is_mathematics = true},
      {.title = "Robots: motion", .functions = motion_functions()},
      {.title = "Robots: velocity commands", .functions = velocity_functions()},
      {.title = "Trajectories", .functions = trajectory_functions(), .is_mathematics = true},
      {.title = "Trajectories: integration",
       .functions = acceleration_functions(),
       .is_mathematics = true},
      {.title = "Trajectories: planners", .functions = planner_functions(), .is_mathematics = true},
      {.title = "Robots: settings", .functions = settings_functions()},
      {.title = "Robots: paths", .functions = path_functions()},
      {.title = "Hands", .functions = hand_functions()},
      {.title = "World and signals", .functions = world_functions()},
      {.title = "The classic subset", .functions = classic_functions()},
      {.title = "Time", .functions = time_functions()},
      {.title = "Tables", .functions = table_functions()},
      {.title = "Figures", .functions = plot_functions()},
      {.title = "Figures: several lines", .functions = plot_line_functions()},
      {.title = "Figures: motions and records", .functions = plot_motion_functions()},
      {.title = "Laboratories", .functions = lab_functions()},
      {.title = "Later", .functions = later_functions()},
  };
  return all;
}

}  // namespace bind

void install(Engine& engine) {
  for (const HostType* type :
       {&bind::kPosJ, &bind::kPosC, &bind::kRobot, &bind::kObject, &bind::kShape, &bind::kTool,
        &bind::kJointRow, &bind::kLab, &bind::kLabRow, &bind::kCamera, &bind::kImage,
        &bind::kTrajectory, &bind::kFinger}) {
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
  engine.add_record("JointEvent", "t: time, kind: string, joint: int, speed: double");
  engine.add_record("Simulation",
                    "t: time[], q: matrix, qd: matrix, tau: matrix, events: JointEvent[], drift: "
                    "energy");
  engine.add_record(
      "TorqueRun", "reached: bool, stopped: bool, time: time, events: JointEvent[], drift: energy");
  engine.add_messages(bind::kLibraryMessages);
  engine.add_foreign_names(bind::kForeignNames);
  engine.add_constants(kConstants, "Mathematics");
  engine.add_planned(kPlanned);
  for (const bind::Chapter& chapter : bind::chapters())
    engine.add_functions(chapter.functions, chapter.title);
}

const Engine& library_engine() {
  static const Engine engine = [] {
    Engine made;
    install(made);
    return made;
  }();
  return engine;
}

std::vector<LibraryChapter> library_chapters() {
  std::vector<LibraryChapter> list;
  for (const bind::Chapter& chapter : bind::chapters())
    list.push_back({chapter.title, chapter.is_mathematics});
  return list;
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
