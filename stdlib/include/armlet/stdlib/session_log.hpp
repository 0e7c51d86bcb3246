#pragma once
// What a session needs to run once more, anywhere: its texts, its options and all that came from
// outside, with the places where it took effect. Everything else follows.

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
// folder  where the files lie that it names; empty: that of the program. It is no part of what the
//         world is: what came out of the files is in the log.
// notes   what it lacks of the file that it was made of, a sentence without an end each.
struct WorldText {
  std::string name;
  std::string text;
  std::string folder{};
  std::vector<std::string> notes{};
  bool operator==(const WorldText& other) const { return name == other.name && text == other.text; }
};

// What the host did to a run.
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
// What people do at the page of a laboratory (laboratory_controls.hpp).
struct PressButton {
  std::string name;  // of the variable that holds what it does: "scaraLab.pickIt"
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

// What the outside replied when the run asked, in the order of asking: contents of files, whether a
// file could be written, output that nobody took.
//
// question  "load points.csv"; what is saved is named by its hash.
struct Reply {
  std::string question;
  std::string text;
  std::optional<Error> error{};
};

// What `import "path"` in the file `from` gave.
struct LoggedImport {
  std::string path;
  std::string from;
  ImportedText given;
};

// What a session was given to run, one thing after the other.
//
// kProgram  a whole program, in a fresh cell: the first entry, if there is one.
// kEntry    a text in the scope of the entries before it (Session::submit).
// kCall     a function of the program, which runs as a program does (Session::begin_call).
enum class EntryKind : std::uint8_t { kProgram, kEntry, kCall };

// One of them, and its run. It begins where the one before has ended.
//
// name        of the text, or of the function.
// arguments   of a call.
// inputs      what the host did meanwhile, and between the end and the beginning of the next one.
// cancelled   where the run noticed wishes to stop.
// stopped_ns  where the host let time pass no further.
// end         how far the run has come, or had when it was left; steps are those of the session.
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
// frames  names of the cameras whose pictures the host gave.
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
  std::vector<RunMark> marks;  // of RunMarks, if the host has put it among its backends
};

// The log as a file (docs/logs.md).
//
// returns  an error if it holds a value of a type of the host, which no file can hold.
[[nodiscard]] Result<std::string> write_log(const SessionLog& log);
// returns  an error that says what was expected where, for everything that write_log of this
// version
//          has not written.
[[nodiscard]] Result<SessionLog> read_log(std::string_view bytes);

}  // namespace armlet
