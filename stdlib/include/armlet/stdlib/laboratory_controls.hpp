#pragma once
// What people do at the page of a laboratory, done to a session.
//
//     SessionOptions options;
//     options.laboratory = true;                // the run goes on after the end of the program
//     Session session(library_engine(), options);
//     session.compile(text, name);
//     session.run(budget);                      // in slices, until session.is_at_rest()
//     LabControls controls(session);
//     if (const auto why = controls.set_field("clearance", Value(80, "mm"))) show(why->message);
//     if (const auto why = controls.press("pickIt")) show(why->message);
//     session.run({.until_ns = t});             // the button's task runs
//
// Every input takes effect where the run stands, also within the program (Session::go_to), and is
// kept in its log, so that a run with inputs is taken again like any other. An input that is
// refused changes nothing and says why.

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
// object  truth: whose corners they are; empty otherwise.
// pixels  x first. Features stand in the order of the rows that the function gives.
struct LabMarks {
  std::string what;
  std::string object{};
  std::vector<std::array<double, 2>> pixels{};
};
// fault  why the function of a view gives no features; empty: it does, or there is none.
struct LabPicture {
  Image image;
  std::vector<LabMarks> marks{};
  std::string fault{};
};

// Of a session with SessionOptions::laboratory, between two slices: its functions throw
// ArgumentError while the session runs. The codes of errors are "no lab" (the program has not come
// to a `lab` block), "unknown", "type", "range", "busy", "unreachable", "ended" and "failed".
class LabControls {
 public:
  explicit LabControls(Session& session) : session_(session) {}

  // Of the `lab` block; null: the program has come to none. Sliders are then known by the names of
  // default_lab_rows.
  [[nodiscard]] const LabRows* rows() const;

  // Sets a field: its unit and its range are checked.
  [[nodiscard]] std::optional<Error> set_field(std::string_view field, const Value& value);
  [[nodiscard]] Result<Value> field(std::string_view field) const;

  // Starts what a button does, as a task beside all others. It runs when the session runs; what
  // becomes of it says SessionOptions::on_press.
  [[nodiscard]] std::optional<Error> press(std::string_view button);

  // Puts an idle robot into a position, rad or m, within the limits of its joints. A robot without
  // a `lab` row can be moved too.
  [[nodiscard]] std::optional<Error> move_joints(std::string_view robot, const Eigen::VectorXd& q);

  // The same by where the hand is, for a row `sliders hand(of: arm, as: "x y z roll")`: one value
  // for each axis, m or rad in the world. The joints stay as near as possible to where they are.
  [[nodiscard]] std::optional<Error> move_hand(std::string_view sliders,
                                               const std::vector<double>& values);
  // Where the sliders of the hand stand now.
  [[nodiscard]] Result<std::vector<double>> hand(std::string_view sliders) const;
  // The smallest and the largest value that each of them can have anywhere in the arm's reach.
  [[nodiscard]] Result<std::vector<std::array<double, 2>>> hand_ranges(
      std::string_view sliders) const;
  // The joints that bring the hand there, without moving it; the reason is that of move_hand.
  [[nodiscard]] Result<Eigen::VectorXd> joints_for_hand(std::string_view sliders,
                                                        const std::vector<double>& values) const;

  // What a plot, a table or a text shows now, or where the features of a view are. It leaves no
  // trace in the run. Joint values and places are lists of numbers with their units; an error says
  // why there is nothing to show.
  [[nodiscard]] Result<Value> read(std::string_view row);
  // The picture of an image that is computed, or of a view, with its marks. It leaves no trace,
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
