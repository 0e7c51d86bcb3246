#include "armlet/stdlib/install.hpp"

#include <numbers>
#include <utility>

#include "bind.hpp"
#include "values.hpp"

namespace armlet {
namespace {

constexpr NativeConstant kConstants[] = {
    {"PI", std::numbers::pi, dims::kNone, "The circumference of a circle over its diameter."},
    {"E", std::numbers::e, dims::kNone, "The base of natural logarithms."},
};

// Names of the language reference without even a signature yet.
constexpr std::string_view kPlanned[] = {"robots.arm7", "urdf", "simulate", "mesh", "touching",
                                         "table", "explain", "lab", "map", "filter", "fold", "any",
                                         "all", "zip", "polyfit", "polyval", "roots", "interp",
                                         "ode", "solve", "minimise",
                                         // settings of with
                                         "with.collisions"};

}  // namespace

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
  engine.add_record("Move", "reached: bool, stopped: bool, time: time, length: length");
  engine.add_record("Wrench", "x: force, y: force, z: force, mx: torque, my: torque, mz: torque");
  engine.add_record("GraspQuality",
                    "contacts: int, minSingular: double, volume: double, forceClosure: bool");
  engine.add_record("Blob", "x: double, y: double, area: double");
  engine.add_record("Match", "x: double, y: double, score: double");
  engine.add_constants(kConstants, "Mathematics");
  engine.add_planned(kPlanned);
  const std::pair<std::string_view, std::span<const NativeFunction>> chapters[] = {
      {"Mathematics", bind::math_functions()},
      {"Lists", bind::list_functions()},
      {"Matrices", bind::matrix_functions()},
      {"Matrices: parts", bind::matrix_part_functions()},
      {"Linear algebra", bind::linalg_functions()},
      {"Text", bind::text_functions()},
      {"Positions and frames", bind::pose_functions()},
      {"Robots: models", bind::model_functions()},
      {"Robots: state and kinematics", bind::robot_functions()},
      {"Robots: motion", bind::motion_functions()},
      {"Robots: settings", bind::settings_functions()},
      {"Hands", bind::hand_functions()},
      {"World and signals", bind::world_functions()},
      {"The classic subset", bind::classic_functions()},
      {"Time", bind::time_functions()},
      {"Tables", bind::table_functions()},
      {"Later", bind::later_functions()},
  };
  for (const auto& [title, functions] : chapters) engine.add_functions(functions, title);
}

}  // namespace armlet
