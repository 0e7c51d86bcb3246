#pragma once
// Inputs of a laboratory from a file, applied without a page: one JSON object in each line.
//
//   {"t": 1.2, "set": "clearance", "value": 0.08}
//   {"t": 2, "press": "pickIt"}
//   {"t": 3, "joints": "arm", "values": [0.1, 0.2, 0.05, 0]}
//   {"t": 4, "hand": "hand", "values": [0.3, 0.1, 0.2, 0]}
//   {"t": 5, "show": "angles"}
//
// Times are seconds of virtual time and do not decrease; values are SI. Empty lines, and lines that
// begin with #, are ignored.

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "commands.hpp"

namespace armlet::cli {

class InputScript {
 public:
  // Returns the exit status, after messages if the file cannot be read or has mistakes. An empty
  // path: no script.
  int read(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return !path_.empty(); }

  // Makes the new session a laboratory if there is a script; `tell` gets the failures of buttons.
  void listen(SessionOptions& session, std::function<void(const Diagnostic&)> tell);

  // Runs the program with these inputs, and then until nothing more happens. The result is a
  // failure also if a button failed or, after a message, if an input was refused.
  RunResult play(Session& session) const;

  struct Set {
    std::string field;
    std::variant<bool, double, std::int64_t, std::string> value;
  };
  struct Press {
    std::string button;
  };
  struct Joints {
    std::string robot;
    std::vector<double> q;
  };
  struct Hand {
    std::string sliders;
    std::vector<double> values;
  };
  struct Show {
    std::string row;
  };
  struct Line {
    int number = 0;
    std::int64_t t_ns = 0;
    std::variant<Set, Press, Joints, Hand, Show> what;
  };

 private:
  void tell(int line, const std::string& why) const;
  // Whether all inputs were accepted.
  bool play_lines(Session& session) const;

  std::string path_;
  std::vector<Line> lines_;
  bool button_failed_ = false;
};

}  // namespace armlet::cli
