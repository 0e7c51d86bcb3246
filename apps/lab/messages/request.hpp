#pragma once
// Messages sent by pages (docs/lab-protocol.md), as values.

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "armlet/core/error.hpp"
#include "text_places.hpp"

namespace armlet::lab {

inline constexpr std::size_t kMostMessageBytes = 1'000'000;
inline constexpr std::size_t kMostTextBytes = 512'000;
inline constexpr std::size_t kMostFileBytes = std::size_t{32} << 20U;  // of a file from a page

struct Hello {
  std::string key{};  // of the page before it was reloaded; empty: it is new
};
struct SetText {
  std::string text;
  std::int64_t version = 0;
  bool runs = true;  // false: the text is only checked
  // Texts with the same number belong to one change: their runs are one entry of the list. 0: none.
  int change = 0;
};
// A question about the text at a position.
struct AskText {
  enum class What : std::uint8_t { kComplete, kHover, kSignature, kDefinition };
  What what = What::kHover;
  TextPlace at{};
};
struct FormatText {};
// The name of the person at the page, as others see it.
struct SetName {
  std::string name;
};
// looks  the cursor does not move, whichever page asks.
struct GoTo {
  double t = 0.0;  // s
  std::optional<int> run{};
  bool looks = false;
};
// A request for the picture of an element at an instant.
struct AskPicture {
  std::string element;
  double t = 0.0;  // s
  std::optional<int> run{};
};
enum class StepHow : std::uint8_t { kInto, kOver, kOut, kBack, kContinue };
struct Step {
  StepHow how = StepHow::kOver;
};
struct SetBreakpoints {
  std::vector<int> lines;
};

// Inputs of a user to a run.
struct SetField {
  std::string name;
  std::variant<double, bool, std::string> value{};  // a number in SI units
  bool operator==(const SetField&) const = default;
};
struct PressButton {
  std::string name;
  bool operator==(const PressButton&) const = default;
};
struct SetJoints {
  std::string robot;
  std::vector<double> q;
  bool operator==(const SetJoints&) const = default;
};
struct SetHand {
  std::string sliders;         // the element
  std::vector<double> values;  // one for each of its axes, m or rad
  bool operator==(const SetHand&) const = default;
};
using InputWhat = std::variant<SetField, PressButton, SetJoints, SetHand>;
struct GiveInput {
  std::optional<double> t{};  // nullopt: at the end of the run
  InputWhat what;
};

struct AskInverse {
  std::string robot;
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  std::vector<double> seed{};
};
struct ShowRun {
  int run = 0;
};
struct CompareRuns {
  int run = 0;
  int with = 0;
};
struct FetchRun {
  int run = 0;
};
struct StopRun {};
// A request for all data with which another laboratory can continue this one.
struct AskExport {};
// Writes the text into the file of the program.
//
// replaces  also if another program has changed the file.
struct SaveText {
  bool replaces = false;
};
// A request for the bytes of a file that is drawn.
struct AskFile {
  std::string name;
};
// A piece of a file to be saved beside the program.
//
// first, last  the file begins, or ends, with this piece.
struct SendFile {
  std::string name;
  std::string bytes{};
  bool first = false;
  bool last = false;
};
struct TakeControl {};
struct GiveControl {
  std::optional<int> to{};
};

struct Request {
  std::optional<std::int64_t> seq{};
  std::variant<Hello, SetText, SetName, AskText, FormatText, GoTo, AskPicture, Step, SetBreakpoints,
               GiveInput, AskInverse, ShowRun, CompareRuns, FetchRun, StopRun, AskExport, SaveText,
               AskFile, SendFile, TakeControl, GiveControl>
      what;
};

// A message that cannot be read, with its number if that could be read.
struct Unreadable {
  std::optional<std::int64_t> seq{};
  std::string why;  // a sentence
};

// Reads a text message; never throws, whatever the message contains.
[[nodiscard]] std::variant<Request, Unreadable> read_request(std::string_view message);

// A pose from seven numbers; nullopt if they are not a pose.
[[nodiscard]] std::optional<Eigen::Isometry3d> pose_of(const std::vector<double>& numbers);

}  // namespace armlet::lab
