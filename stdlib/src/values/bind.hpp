#pragma once
// Declarations shared by the chapters of the library: their tables, and helpers that read arguments
// and report failures.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/engine.hpp"

namespace armlet::bind {

// The chapters of the library reference: one table each, or a few.
struct Chapter {
  std::string_view title;
  std::span<const NativeFunction> functions;
  bool is_mathematics = false;  // its functions are in docs/mathematics.md
  bool only_values = false;     // its functions only return values and change nothing else
};
[[nodiscard]] std::span<const Chapter> chapters();

std::span<const NativeFunction> math_functions();
std::span<const NativeFunction> random_functions();
std::span<const NativeFunction> list_functions();
std::span<const NativeFunction> matrix_functions();
std::span<const NativeFunction> matrix_part_functions();
std::span<const NativeFunction> linalg_functions();
std::span<const NativeFunction> vector_functions();
std::span<const NativeFunction> numeric_functions();
std::span<const NativeFunction> ode_functions();
std::span<const NativeFunction> text_functions();
std::span<const NativeFunction> pose_functions();
std::span<const NativeFunction> rotation_functions();
std::span<const NativeFunction> robot_functions();
std::span<const NativeFunction> ikine_functions();
std::span<const NativeFunction> ikine_info_functions();
std::span<const NativeFunction> control_functions();
std::span<const NativeFunction> dynamics_functions();
std::span<const NativeFunction> identification_functions();
std::span<const NativeFunction> simulation_functions();
std::span<const NativeFunction> model_functions();
std::span<const NativeFunction> body_functions();
std::span<const NativeFunction> dh_functions();
std::span<const NativeFunction> view_functions();
std::span<const NativeFunction> motion_functions();
std::span<const NativeFunction> trajectory_functions();
std::span<const NativeFunction> acceleration_functions();
std::span<const NativeFunction> planner_functions();
std::span<const NativeFunction> velocity_functions();
std::span<const NativeFunction> settings_functions();
std::span<const NativeFunction> path_functions();
std::span<const NativeFunction> hand_functions();
std::span<const NativeFunction> finger_functions();
std::span<const NativeFunction> world_functions();
std::span<const NativeFunction> object_functions();
std::span<const NativeFunction> frame_functions();
std::span<const NativeFunction> drawing_functions();
std::span<const NativeFunction> classic_functions();
std::span<const NativeFunction> time_functions();
std::span<const NativeFunction> table_functions();
std::span<const NativeFunction> plot_functions();
std::span<const NativeFunction> plot_line_functions();
std::span<const NativeFunction> plot_motion_functions();
std::span<const NativeFunction> show_functions();
std::span<const NativeFunction> lab_functions();
std::span<const NativeFunction> lab_picture_functions();
std::span<const NativeFunction> picture_value_functions();
std::span<const NativeFunction> picture_file_functions();
std::span<const NativeFunction> snapshot_functions();
std::span<const NativeFunction> camera_functions();
std::span<const NativeFunction> sight_functions();
std::span<const NativeFunction> feature_functions();
std::span<const NativeFunction> tracker_functions();
std::span<const NativeFunction> servo_functions();
std::span<const NativeFunction> opencv_functions();
std::span<const NativeFunction> marker_functions();
std::span<const NativeFunction> shape_functions();
std::span<const NativeFunction> calibration_functions();

// R0609: `function` of `value`: the value must `requirement`. Marks argument `parameter`.
Failed domain_failure(Vm& vm, std::string_view function, double value, std::string_view requirement,
                      std::string fix = {}, CallPart part = CallPart::first());
// R0612: an argument that is infinite or not a number.
Failed not_finite(Vm& vm, std::string_view what, double value, CallPart part);
// R0613: two sizes that do not match.
Failed size_failure(Vm& vm, std::string_view what, std::size_t left, std::size_t right);

// A failure of a native function with a code of the catalogue and its own headline.
Failed failure(Vm& vm, KnownCode code, std::string message, CallPart part = {},
               std::string why = {}, std::string fix = {});

// A failure whose headline has the sentence of a broken precondition as its argument.
Failed failure_of(Vm& vm, MessageCode<1> code, const std::exception& error, CallPart part = {},
                  std::string fix = {});

// The sentence of a broken precondition in a form that can follow other words, without capital and
// full stop.
[[nodiscard]] std::string clause_of(const std::exception& error);

}  // namespace armlet::bind
