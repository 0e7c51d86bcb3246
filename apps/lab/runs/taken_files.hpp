#pragma once
// The files that the programs of a laboratory import and load, so that it can continue where these
// do not exist.

#include <map>
#include <memory>
#include <string>

#include "armlet/stdlib/session.hpp"

namespace armlet::lab {

class TakenFiles {
 public:
  // Adds the result of `import "path"` in the file with the name `from`.
  void add_import(const std::string& path, const std::string& from, const ImportedText& given);
  // Adds the files that the run of a log has loaded and had not saved before.
  void add_loaded(const SessionLog& log);
  // Texts by their paths from the folder of the program.
  [[nodiscard]] const std::map<std::string, std::string>& all() const { return files_; }

 private:
  std::map<std::string, std::string> files_;
  std::map<std::string, std::string> paths_;  // of imported files, by their names
};

// Session options with a loader that adds imports to `files`, which sessions share.
[[nodiscard]] SessionOptions noting(SessionOptions options, std::shared_ptr<TakenFiles> files);

}  // namespace armlet::lab
