#pragma once
// Inputs that users make at the page of a laboratory, applied to a session.
//
//     SessionOptions options;
//     options.laboratory = true;                // the run goes on after the end of the program
//     Session session(library_engine(), options);
//     session.compile(text, name);
//     session.run(budget);                      // in slices, until session.is_at_rest()
//     LabControls controls(session);
//     if (const auto why = controls.set_field("clearance", Value(80, "mm"))) show(why->message);
//     if (const auto why = controls.press("pickIt")) show(why->message);
//     session.run({.until_ns = t});             // runs the task of the button
//
// Every input takes effect at the present instant of the run, also while the program is executed
// (Session::go_to). The log of the session records it, so that a run with inputs can be replayed.
// An input that is refused changes nothing; the error says why.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet {

// Points in a picture.
//
// what    "corner", "truth", "wanted" or "feature".
// object  for "truth": the object whose corners they are; otherwise empty.
// pixels  x first. Features have the order of the rows that the function returns.
struct LabMarks {
  std::string what;
  std::string object{};
  std::vector<std::array<double, 2>> pixels{};
};
// fault  why the function of a view returns no features; empty: it returns some, or there is none.
struct LabPicture {
  Image image;
  std::vector<LabMarks> marks{};
  std::string fault{};
};

// Controls of a session with SessionOptions::laboratory, used between two slices: the functions
// throw ArgumentError while the session runs. The codes of errors are "no lab" (no `lab` block has
// been executed), "unknown", "type", "range", "busy", "unreachable", "ended" and "failed".
class LabControls {
 public:
  explicit LabControls(Session& session) : session_(session) {}

  // The rows of the `lab` block; null: none has been executed. Sliders then have the names of
  // default_lab_rows.
  [[nodiscard]] const LabRows* rows() const;

  // Sets a field; the unit and the range of the value are checked.
  [[nodiscard]] std::optional<Error> set_field(std::string_view field, const Value& value);
  [[nodiscard]] Result<Value> field(std::string_view field) const;

  // Starts the action of a button, as a task beside all others. It runs when the session runs; its
  // result is reported by SessionOptions::on_press.
  [[nodiscard]] std::optional<Error> press(std::string_view button);

  // Moves an idle robot at once to joint values, rad or m, within the limits of its joints. This
  // also works for a robot without a `lab` row.
  [[nodiscard]] std::optional<Error> move_joints(std::string_view robot, const Eigen::VectorXd& q);

  // Moves an idle robot at once to a pose of the tool, for a row `sliders hand(of: arm, as: "x y z
  // roll")`: one value for each axis, m or rad in the world. Takes the solution nearest to the
  // present joint values.
  [[nodiscard]] std::optional<Error> move_hand(std::string_view sliders,
                                               const std::vector<double>& values);
  // The present values of the sliders of the tool pose.
  [[nodiscard]] Result<std::vector<double>> hand(std::string_view sliders) const;
  // The smallest and the largest value of each of these sliders anywhere in the arm's reach.
  [[nodiscard]] Result<std::vector<std::array<double, 2>>> hand_ranges(
      std::string_view sliders) const;
  // The joint values for that tool pose, without moving the arm; errors are those of move_hand.
  [[nodiscard]] Result<Eigen::VectorXd> joints_for_hand(std::string_view sliders,
                                                        const std::vector<double>& values) const;

  // The present contents of a plot, a table or a text, or the features of a view. The run does not
  // change. Joint values and poses are lists of numbers with their units; an error has the reason
  // if there is nothing to show.
  [[nodiscard]] Result<Value> read(std::string_view row);
  // The picture of a computed image, or of a view, with its marks. The run does not change,
  // either.
  [[nodiscard]] Result<LabPicture> picture(std::string_view row);

 private:
  struct Hand {
    const CellRobot* robot;
    std::vector<HandAxis> axes;
  };
  [[nodiscard]] std::optional<Error> refusal() const;
  [[nodiscard]] std::optional<Error> apply(const Action& action);
  [[nodiscard]] Result<Hand> find_hand(std::string_view sliders) const;
  [[nodiscard]] Result<Value> call(const LabRow& row, std::span<const Value> arguments = {});
  [[nodiscard]] Image seen(const LabRow& view);
  [[nodiscard]] Result<Value> features(const LabRow& view, const Image& image);

  Session& session_;
};

}  // namespace armlet
