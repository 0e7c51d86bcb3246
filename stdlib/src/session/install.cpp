#include "armlet/stdlib/install.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "laboratory/lab_values.hpp"
#include "messages/foreign_names.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet {
namespace {

constexpr NativeConstant kConstants[] = {
    {"PI", std::numbers::pi, dims::kNone, "The circumference of a circle over its diameter."},
    {"E", std::numbers::e, dims::kNone, "The base of natural logarithms."},
};

}  // namespace

namespace bind {

namespace {

Chapter mathematics(std::string_view title, std::span<const NativeFunction> functions) {
  return {.title = title, .functions = functions, .is_mathematics = true, .only_values = true};
}
Chapter values(std::string_view title, std::span<const NativeFunction> functions) {
  return {.title = title, .functions = functions, .only_values = true};
}

// Appends the chapters about pictures.
std::vector<Chapter> with_pictures(std::vector<Chapter> chapters) {
  const Chapter more[] = {
      {.title = "Pictures", .functions = picture_value_functions(), .only_values = true},
      {.title = "Pictures: files", .functions = picture_file_functions()},
      {.title = "Cameras", .functions = camera_functions()},
      {.title = "Cameras: what they see", .functions = sight_functions()},
      {.title = "Cameras: pictures of the cell", .functions = snapshot_functions()},
      {.title = "Pictures: features", .functions = feature_functions(), .only_values = true},
      {.title = "Pictures: tracking", .functions = tracker_functions()},
      {.title = "Visual servoing", .functions = servo_functions()},
      values("Pictures: OpenCV", opencv_functions()),
      values("Pictures: shapes and flow", shape_functions()),
      values("Pictures: markers and solids", marker_functions()),
      values("Cameras: calibration", calibration_functions()),
  };
  chapters.insert(chapters.end(), std::begin(more), std::end(more));
  return chapters;
}

}  // namespace

std::span<const Chapter> chapters() {
  static const std::vector<Chapter> all = with_pictures({
      mathematics("Mathematics", math_functions()),
      {.title = "Random numbers", .functions = random_functions(), .is_mathematics = true},
      {.title = "Lists", .functions = list_functions(), .only_values = true},
      mathematics("Vectors", vector_functions()),
      mathematics("Matrices", matrix_functions()),
      mathematics("Matrices: parts", matrix_part_functions()),
      mathematics("Linear algebra", linalg_functions()),
      mathematics("Fits, roots and equations", numeric_functions()),
      mathematics("Differential equations", ode_functions()),
      {.title = "Text", .functions = text_functions(), .only_values = true},
      mathematics("Positions and frames", pose_functions()),
      mathematics("Positions and frames: orientations", rotation_functions()),
      mathematics("Robots: models", model_functions()),
      {.title = "Robots: shapes of links", .functions = body_functions(), .only_values = true},
      mathematics("Robots: tables", dh_functions()),
      {.title = "Robots: variables of the 2011 platform", .functions = view_functions()},
      mathematics("Robots: state and kinematics", robot_functions()),
      mathematics("Robots: inverse kinematics", ikine_functions()),
      mathematics("Robots: inverse kinematics as values", ikine_info_functions()),
      mathematics("Robots: dynamics", dynamics_functions()),
      mathematics("Robots: identification", identification_functions()),
      mathematics("Robots: simulation", simulation_functions()),
      mathematics("Robots: control", control_functions()),
      {.title = "Robots: motion", .functions = motion_functions()},
      {.title = "Robots: velocity commands", .functions = velocity_functions()},
      mathematics("Trajectories", trajectory_functions()),
      mathematics("Trajectories: integration", acceleration_functions()),
      mathematics("Trajectories: planners", planner_functions()),
      {.title = "Robots: settings", .functions = settings_functions()},
      {.title = "Robots: paths", .functions = path_functions()},
      {.title = "Hands", .functions = hand_functions()},
      {.title = "Hands with fingers", .functions = finger_functions()},
      {.title = "Objects", .functions = object_functions()},
      {.title = "World and signals", .functions = world_functions()},
      {.title = "Frames with names", .functions = frame_functions()},
      {.title = "Shapes that are only shown", .functions = drawing_functions()},
      {.title = "The classic subset", .functions = classic_functions()},
      {.title = "Time", .functions = time_functions()},
      {.title = "Tables", .functions = table_functions()},
      {.title = "Figures", .functions = plot_functions()},
      {.title = "Figures: several lines", .functions = plot_line_functions()},
      {.title = "Figures: motions and records", .functions = plot_motion_functions()},
      {.title = "Figures: pictures", .functions = show_functions()},
      {.title = "Laboratories", .functions = lab_functions()},
      {.title = "Laboratories: pictures", .functions = lab_picture_functions()},
  });
  return all;
}

}  // namespace bind

namespace {

void add_picture_records(Engine& engine) {
  engine.add_record("Color", "r: int, g: int, b: int");
  engine.add_record("Blob",
                    "x: double, y: double, area: int, angle: angle, width: double, height: double, "
                    "color: Color");
  engine.add_record("PlanarPose", "pose: posC, error: double, other: posC, otherError: double");
  engine.add_record("ServoGain", "atZero: double, atInfinity: double, slope: double");
  engine.add_record("ServoRun",
                    "reason: string, why: string, t: time[], error: double[], twist: matrix, "
                    "features: matrix, smallest: double[], condition: double[], qd: matrix, "
                    "uncontrollable: matrix, explanation: string");
  engine.add_record("Flow", "points: matrix, lost: int[]");
  engine.add_record("SolidPose", "pose: posC, error: double");
  engine.add_record("Marker", "id: int, corners: matrix");
  engine.add_record("Calibration",
                    "K: matrix, distortion: double[], error: double, deviation: double[], poses: "
                    "posC[]");
  engine.add_record("HandEye", "pose: posC, error: length, tilt: angle");
  engine.add_record("Match", "x: double, y: double, score: double");
}

}  // namespace

void install(Engine& engine) {
  for (const HostType* type :
       {&bind::kPosJ, &bind::kPosC, &bind::kRobot, &bind::kObject, &bind::kFrame, &bind::kShape,
        &bind::kTool, &bind::kJointRow, &bind::kBodyRow, &bind::kLab, &bind::kLabRow,
        &bind::kCamera, &bind::kImage, &bind::kTracker, &bind::kTrajectory, &bind::kFinger}) {
    engine.add_type(*type);
  }
  engine.add_record("Lu", "L: matrix, U: matrix, P: matrix");
  engine.add_record("Qr", "Q: matrix, R: matrix");
  engine.add_record("Svd", "U: matrix, s: double[], V: matrix");
  engine.add_record("Eig", "values: double[], vectors: matrix");
  engine.add_record("Eigenvalues", "re: double[], im: double[]");
  engine.add_record("Move",
                    "reached: bool, stopped: bool, time: time, length: length, deviation: length, "
                    "worstJoint: int, beyond: double");
  engine.add_record("IkInfo",
                    "found: bool, q: posJ, method: string, branch: string, iterations: int, "
                    "residual: length, tilt: angle, distance: length, nearest: posC, worstJoint: "
                    "int, margin: double[]");
  engine.add_record("Wrench", "x: force, y: force, z: force, mx: torque, my: torque, mz: torque");
  engine.add_record("ClosestPoints",
                    "distance: length, from: posC, to: posC, body: string, other: string");
  engine.add_record("GraspQuality",
                    "epsilon: double, minSingular: double, contacts: int, forceClosure: bool");
  add_picture_records(engine);
  engine.add_record("Compliance", "offset: double[], rate: double[]");
  engine.add_record("BaseParameters", "columns: int[], grouping: matrix, values: double[]");
  engine.add_record("OdeEvent", "g: fn(double, double[]) -> double, direction: string, stop: bool");
  engine.add_record("OdeCrossing", "t: time, event: int, y: double[]");
  engine.add_record("OdeSolution", "t: time[], y: matrix, events: OdeCrossing[]");
  engine.add_record("JointEvent", "t: time, kind: string, joint: int, speed: double");
  engine.add_record("Simulation",
                    "t: time[], q: matrix, qd: matrix, tau: matrix, events: JointEvent[], drift: "
                    "energy, clipped: time");
  engine.add_record(
      "TorqueRun",
      "reached: bool, stopped: bool, time: time, events: JointEvent[], drift: energy, "
      "clipped: time");
  engine.add_messages(bind::kLibraryMessages);
  engine.add_foreign_names(bind::kForeignNames);
  engine.add_constants(kConstants, "Mathematics");
  for (const bind::Chapter& chapter : bind::chapters()) {
    engine.add_functions(chapter.functions, chapter.title);
    if (chapter.only_values) engine.only_values(chapter.functions);
  }
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

}  // namespace armlet
