#pragma once
// What a `lab` block says: the page of a virtual laboratory as values, for whoever shows it.

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
// "sliders", "field", ...: the word of the row in programs.
[[nodiscard]] std::string_view word_of(LabRowKind kind);

enum class LabLayout { kColumns, kStack };

// What the row of a camera marks in its picture: corners that are found there, the true corners of
// objects that are in view, or only pixels that the program names.
enum class LabOverlay { kNone, kCorners, kTruth, kWanted };

// What a hand slider sets of the tool point in the world, m or rad.
//
// kTurn  the turn about z, with the tilt of the tool as it is: "roll" without "pitch" and "yaw".
enum class HandAxis { kX, kY, kZ, kRoll, kPitch, kYaw, kTurn };
// "x", "y", "z", "roll", "pitch", "yaw", "roll".
[[nodiscard]] std::string_view word_of(HandAxis axis);

enum class LabFieldType { kNumber, kInt, kBool, kText };

// The dimension of a number, or of those of the joints of a robot, which the run knows.
//
// robot    its name in the cell; empty: `dim` holds. Otherwise `dim` is that of a joint that turns,
//          `sliding` that of one that slides.
// joint    of which one, from 0; -1: all of them, a number for each.
struct LabNumber {
  Dim dim{};
  std::string robot{};
  Dim sliding{};
  int joint = -1;
};

// One element of the page. What a kind does not use stays empty.
//
// name     by which programs and inputs call it; it is unique in the block.
// label    what the page writes beside it; the name where the program gives none.
// robot    sliders, trail, torques: of the robot with this name.
// axes     sliders: of the hand; empty: one slider for each joint.
// type     field: what it holds. A number with a unit has `dim` and `unit`.
// dim      of the value of a field.
// unit     "mm", in which people read and write it; empty: a plain number, or no number.
// value    field: what it holds at the start. text: Markdown with formulas, where it never changes.
// range    field: smallest and largest value, SI.
// header   table: over its columns.
// dims     plot, table: of the things in what is read, in their order, where their type has none,
//          as speeds of joints in a double[]; empty: nothing is known of them.
// picture  image: the bytes of its file, PNG or JPEG; null: LabControls::picture gives what it
// shows. camera   view: by its name in the cell. overlay  view: what is marked beside the features
// of its function. wanted   view: pixels at which features are to be, x first. is_read  plot,
// table, and text that changes: LabControls::read gives what it shows now. image: it
//          is computed. view: it has a function that gives features.
// takes_picture  view: the function is given the picture.
// at       where the program says so; empty: it does not.
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

// A `lab` block that the program has come to.
//
// name   of the block: a field `clearance` is the variable `name.clearance`.
// title  the name of the block where the program gives none.
struct LabRows {
  std::string name;
  std::string title;
  LabLayout layout = LabLayout::kColumns;
  std::vector<LabRow> rows{};

  // Null if there is none of this name.
  [[nodiscard]] const LabRow* find(std::string_view row) const;
};

// The page of a program without a `lab` block: sliders for the joints and the hand of each robot of
// a cell, and plots of its joints and their speeds. Such a plot has no lambda (is_read) but a
// robot, and is named "q of arm" or "qd of arm".
[[nodiscard]] LabRows default_lab_rows(const Cell& cell);

}  // namespace armlet
