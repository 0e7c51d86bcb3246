#pragma once
// What pages send (docs/lab-protocol.md), as values.

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
inline constexpr std::size_t kMostFileBytes = std::size_t{32} << 20U;  // that a page sends

struct Hello {
  std::string key{};  // of the page as it was before; empty: it is new
};
struct SetText {
  std::string text;
  std::int64_t version = 0;
  bool runs = true;  // otherwise it is only checked
};
// A question about the text at a place.
struct AskText {
  enum class What : std::uint8_t { kComplete, kHover, kSignature, kDefinition };
  What what = What::kHover;
  TextPlace at{};
};
struct FormatText {};
// looks  the cursor stays where it is, whoever asks.
struct GoTo {
  double t = 0.0;  // s
  std::optional<int> run{};
  bool looks = false;
};
// The picture of an element at an instant.
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

// What a user does to a run.
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
  std::optional<double> t{};  // nothing: at the end of the run
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
// Everything that another laboratory needs to go on with this one.
struct AskExport {};
// The bytes of a file that is drawn.
struct AskFile {
  std::string name;
};
// A piece of a file that is to be kept beside the program.
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
  std::variant<Hello, SetText, AskText, FormatText, GoTo, AskPicture, Step, SetBreakpoints,
               GiveInput, AskInverse, ShowRun, CompareRuns, FetchRun, StopRun, AskExport, AskFile,
               SendFile, TakeControl, GiveControl>
      what;
};

// A message that cannot be read, with its number as far as that could be read.
struct Unreadable {
  std::optional<std::int64_t> seq{};
  std::string why;  // a sentence
};

// Reads a text message; never throws for what it holds.
[[nodiscard]] std::variant<Request, Unreadable> read_request(std::string_view message);

// A pose of seven numbers; nothing if they are none.
[[nodiscard]] std::optional<Eigen::Isometry3d> pose_of(const std::vector<double>& numbers);

}  // namespace armlet::lab
