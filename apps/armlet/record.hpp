#pragma once
// The log of a session as a file, from which `armlet replay` takes it again.

#include <string>
#include <vector>

#include "armlet/stdlib/session_log.hpp"
#include "output_file.hpp"

namespace armlet::cli {

class Record {
 public:
  // The exit status, after a message if this is no name of a record; empty: none is wanted.
  int choose(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return file_.is_wanted(); }
  // As OutputFile does.
  int open(const std::vector<std::string>& texts);
  int finish(const SessionLog& log);
  void give_up() { file_.give_up(); }

 private:
  OutputFile file_{"record"};
};

}  // namespace armlet::cli
