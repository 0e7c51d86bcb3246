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

// Functions, types and fields of the language reference that do not exist yet.
constexpr std::string_view kPlanned[] = {
    // motion
    "moveCirc", "moveSpline", "follow", "speedJ", "speedC", "halt", "trajectory", "plan",
    // robots, hands, tools
    "robots.arm7", "robots.barrettHand", "urdf", "setPayload", "finger", "graspQuality",
    "closeHand", "openHand", "ikineAll", "jacobian", "dhTable", "torques", "invDyn", "fwdDyn",
    "massMatrix", "coriolis", "gravity", "friction", "simulate",
    // lists and matrices
    "matrix", "map", "filter", "fold", "any", "all", "zip", "flatten", "eye", "diag", "hcat",
    "vcat", "outer", "det", "rank", "trace", "pinv", "lu", "qr", "chol", "svd", "eig", "expm",
    "polyfit", "polyval", "roots", "interp", "ode", "solve", "minimise", "posC.R", "posC.T",
    // world, cameras, output
    "mesh", "touching", "corners", "camera", "image", "capture", "project", "depth",
    "interactionMatrix", "gray", "blur", "threshold", "edges", "blobs", "lines", "circles", "match",
    "table", "plot", "scatter", "scatter3", "bars", "figure", "savePlot", "show", "trail",
    "loadImage", "explain"};

}  // namespace

void install(Engine& engine) {
  for (const HostType* type : {&bind::kPosJ, &bind::kPosC, &bind::kRobot, &bind::kObject,
                               &bind::kShape, &bind::kTool, &bind::kJointRow}) {
    engine.add_type(*type);
  }
  engine.add_record("Move", "reached: bool, stopped: bool, time: time, length: length");
  engine.add_record("Wrench", "x: force, y: force, z: force, mx: torque, my: torque, mz: torque");
  engine.add_constants(kConstants, "Mathematics");
  engine.add_planned(kPlanned);
  const std::pair<std::string_view, std::span<const NativeFunction>> chapters[] = {
      {"Mathematics", bind::math_functions()},
      {"Lists", bind::list_functions()},
      {"Text", bind::text_functions()},
      {"Positions and frames", bind::pose_functions()},
      {"Robots: models", bind::model_functions()},
      {"Robots: state and kinematics", bind::robot_functions()},
      {"Robots: motion", bind::motion_functions()},
      {"Hands", bind::hand_functions()},
      {"World and signals", bind::world_functions()},
      {"The classic subset", bind::classic_functions()},
      {"Time", bind::time_functions()},
  };
  for (const auto& [title, functions] : chapters) engine.add_functions(functions, title);
}

}  // namespace armlet
