#pragma once
// The contents of a `lab` block: the page of a virtual laboratory as values, for any display.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/unit.hpp"

namespace armlet {

class Cell;

// The rows of a `lab` block, in the order of the language reference (section 16).
enum class LabRowKind {
  kSliders,
  kField,
  kButton,
  kPlot,
  kTable,
  kText,
  kImage,
  kTrail,
  kTorques,
  kView,
  kProgram,
};
// "sliders", "field", ...: the word for this kind of row in programs.
[[nodiscard]] std::string_view word_of(LabRowKind kind);

enum class LabLayout { kColumns, kStack };

// What the row of a camera marks in its picture: corners that are detected there, the true corners
// of objects in view, or only pixels that the program names.
enum class LabOverlay { kNone, kCorners, kTruth, kWanted };

// What a slider of the tool pose sets, in the world, m or rad.
//
// kTurn  rotation about z that keeps the tilt of the tool: "roll" without "pitch" and "yaw".
enum class HandAxis { kX, kY, kZ, kRoll, kPitch, kYaw, kTurn };
// "x", "y", "z", "roll", "pitch", "yaw", "roll".
[[nodiscard]] std::string_view word_of(HandAxis axis);

enum class LabFieldType { kNumber, kInt, kBool, kText };

// The dimension of a number, or of joint values of a robot whose joints the run knows.
//
// robot    name of the robot in the cell; empty: the number has the dimension `dim`. Otherwise
//          `dim` is for revolute joints and `sliding` for prismatic ones.
// joint    index of the joint, from 0; -1: all joints, one number for each.
struct LabNumber {
  Dim dim{};
  std::string robot{};
  Dim sliding{};
  int joint = -1;
};

// One element of the page. Members that a kind does not use stay empty.
//
// name     name in programs and inputs; unique in the block.
// label    caption on the page; `name` where the program gives none.
// robot    sliders, trail, torques: of the robot with this name.
// axes     sliders: of the tool pose; empty: one slider for each joint.
// type     field: type of its value. A number with a unit has `dim` and `unit`.
// dim      field: dimension of its value.
// unit     "mm", the unit that users read and write; empty: a plain number, or no number.
// value    field: initial value. text: Markdown with formulas, if it never changes.
// range    field: smallest and largest value, SI.
// header   table: headings of its columns.
// dims     plot, table: dimensions of the numbers that are read, in their order, where their type
//          has none, as speeds of joints in a double[]; empty: unknown.
// picture  image: the bytes of its file, PNG or JPEG; null: LabControls::picture returns it.
// camera   view: name of the camera in the cell.
// overlay  view: what is marked in addition to the features of its function.
// wanted   view: goal pixels of the features, x first.
// is_read  plot, table, and text that changes: LabControls::read returns the present contents.
//          image: it is computed. view: it has a function that returns features.
// takes_picture  view: the function gets the picture as its argument.
// at       position on the page; empty: the program does not give one.
struct LabRow {
  LabRowKind kind = LabRowKind::kText;
  std::string name{};
  std::string label{};
  std::string robot{};
  std::vector<HandAxis> axes{};
  LabFieldType type = LabFieldType::kNumber;
  Dim dim{};
  std::string unit{};
  Value value{};
  std::optional<std::array<double, 2>> range{};
  std::vector<std::string> header{};
  std::vector<LabNumber> dims{};
  std::shared_ptr<const std::string> picture{};
  std::string camera{};
  LabOverlay overlay = LabOverlay::kNone;
  std::vector<std::array<double, 2>> wanted{};
  bool is_read = false;
  bool takes_picture = false;
  Span at{};
};

// A `lab` block that has been executed.
//
// name   name of the block: a field `clearance` is the variable `name.clearance`.
// title  the name of the block where the program gives no title.
struct LabRows {
  std::string name;
  std::string title;
  LabLayout layout = LabLayout::kColumns;
  std::vector<LabRow> rows{};

  // Null if no row has this name.
  [[nodiscard]] const LabRow* find(std::string_view row) const;
};

// The page of a program without a `lab` block: sliders for the joints and the tool pose of each
// robot of a cell, and plots of its joint values and speeds. Such a plot has no lambda (is_read)
// but a robot, and is named "q of arm" or "qd of arm".
[[nodiscard]] LabRows default_lab_rows(const Cell& cell);

}  // namespace armlet
