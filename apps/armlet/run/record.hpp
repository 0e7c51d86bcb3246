#pragma once
// The log of a session as a file, which `armlet replay` replays.

#include <string>
#include <vector>

#include "armlet/stdlib/session_log.hpp"
#include "console/output_file.hpp"

namespace armlet::cli {

class Record {
 public:
  // Returns the exit status, after a message if this is no file name for a log; empty: no log.
  int choose(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return file_.is_wanted(); }
  // Called once it is known that the program runs. The texts are files that the log must not
  // overwrite. Returns the exit status, after a message if the log cannot be written.
  int open(const std::vector<std::string>& texts);
  int finish(const SessionLog& log);
  void give_up() { file_.give_up(); }

 private:
  OutputFile file_{"record"};
};

}  // namespace armlet::cli
