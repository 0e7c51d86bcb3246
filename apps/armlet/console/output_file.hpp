#pragma once
// A file that a command writes and that replaces the old one when the command has ended.

#include <optional>
#include <string>
#include <vector>

#include "armlet/core/files.hpp"

namespace armlet::cli {

class OutputFile {
 public:
  // what  the word for it in messages: "trace".
  explicit OutputFile(std::string what) : what_(std::move(what)) {}

  void set_path(std::string path) { path_ = std::move(path); }
  [[nodiscard]] bool is_wanted() const { return !path_.empty(); }
  // Called once it is known that the file will be written. It must not be one of the files `texts`.
  // Returns the exit status, after a message if it is not kDone.
  int open(const std::vector<std::string>& texts);
  [[nodiscard]] NewFile& file() { return *file_; }
  // Removes the unfinished file; it is not needed any more.
  void give_up() {
    file_.reset();
    path_.clear();
  }
  // Gives the file its name. Returns the exit status, as above.
  int finish();

 private:
  int refuse(const std::string& why, int exit) const;

  std::string what_;
  std::string path_;
  std::optional<NewFile> file_;
};

}  // namespace armlet::cli
