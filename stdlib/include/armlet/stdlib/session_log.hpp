#pragma once
// All that is needed to replay a session on any machine: its texts, its options and all inputs from
// outside, with the instants at which they took effect. Everything else follows from these.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "armlet/backend/run_marks.hpp"
#include "armlet/cell/signals.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/value.hpp"

namespace armlet {

// A program that declares objects and frames, such as worlds/table.rbt.
//
// folder  folder of the files that it names; empty: that of the program. It is not part of the
//         identity of the world: the contents of the files are in the log.
// notes   what was left out of the file that it was made from; sentences without a full stop.
struct WorldText {
  std::string name;
  std::string text;
  std::string folder{};
  std::vector<std::string> notes{};
  bool operator==(const WorldText& other) const { return name == other.name && text == other.text; }
};

// Inputs of the host to a run.
struct SetSignal {
  std::string name;
  SignalValue value;
  bool operator==(const SetSignal&) const = default;
};
struct SetGlobal {
  std::string name;
  Value value;
  bool operator==(const SetGlobal&) const = default;
};
struct CallFunction {
  std::string name;
  std::vector<Value> arguments;
  bool operator==(const CallFunction&) const = default;
};
// Inputs of users at the page of a laboratory (laboratory_controls.hpp).
struct PressButton {
  std::string name;  // the variable that holds its action: "scaraLab.pickIt"
  bool operator==(const PressButton&) const = default;
};
struct MoveJoints {
  std::string robot;
  std::vector<double> q;  // rad or m
  bool operator==(const MoveJoints&) const = default;
};
using Action = std::variant<SetSignal, SetGlobal, CallFunction, PressButton, MoveJoints>;
struct Input {
  Instant at{};
  Action what;
  bool operator==(const Input&) const = default;
};

// Replies from outside to questions of the run, in the order of the questions: contents of files,
// whether a file could be written, output that nobody received.
//
// question  "load points.csv"; for saved files, with the hash of their contents.
struct Reply {
  std::string question;
  std::string text;
  std::optional<Error> error{};
};

// The file that `import "path"` in the file `from` loaded.
struct LoggedImport {
  std::string path;
  std::string from;
  ImportedText given;
};

// The kinds of entries that a session runs, one after the other.
//
// kProgram  a whole program, in a fresh cell: the first entry, if there is one.
// kEntry    a text in the scope of the entries before it (Session::submit).
// kCall     a function of the program, which runs as a program does (Session::begin_call).
enum class EntryKind : std::uint8_t { kProgram, kEntry, kCall };

// An entry and its run. It begins at the instant at which the one before has ended.
//
// name        of the text, or of the function.
// arguments   of a call.
// inputs      inputs of the host during the entry, and between its end and the next one.
// cancelled   the instants at which the run noticed stop requests.
// stopped_ns  the time at which the host stopped the clock.
// end         the instant that the run has reached, or had when it was left; steps are counted over
//             the session.
struct LoggedEntry {
  EntryKind kind = EntryKind::kProgram;
  std::string name;
  std::string text;
  std::vector<Value> arguments{};
  std::vector<LoggedImport> imports{};
  std::vector<Input> inputs{};
  std::vector<Reply> replies{};
  std::vector<Cancellation> cancelled{};
  std::vector<std::int64_t> stopped_ns{};
  Instant end{};
};

// robot   the name of the host's robot; empty: it has none. The same for its planners.
// frames  names of the cameras whose pictures the host supplied.
struct SessionLog {
  std::string robot;
  std::vector<std::string> planners;
  std::vector<std::string> frames{};
  std::optional<WorldText> world;
  std::optional<WorldText> default_world;
  RunLimits limits;
  bool open = false;
  bool laboratory = false;
  std::vector<LoggedEntry> entries;
  std::vector<RunMark> marks;  // from RunMarks, if it is a backend of the host
};

// The log as a file (docs/logs.md).
//
// returns  an error if it holds a value of a type of the host, which cannot be written to a file.
[[nodiscard]] Result<std::string> write_log(const SessionLog& log);
// Reads a log that write_log of this version has written.
//
// returns  an error for anything else: which position expected what.
[[nodiscard]] Result<SessionLog> read_log(std::string_view bytes);

}  // namespace armlet
