#pragma once
// The files that the programs of a laboratory import and load, so that it can go on where these are
// not.

#include <map>
#include <memory>
#include <string>

#include "armlet/stdlib/session.hpp"

namespace armlet::lab {

class TakenFiles {
 public:
  // What `import "path"` in the file `from`, as it is named, has given.
  void add_import(const std::string& path, const std::string& from, const ImportedText& given);
  // What the run of a log has loaded and had not saved before.
  void add_loaded(const SessionLog& log);
  // Texts by their paths from the folder of the program.
  [[nodiscard]] const std::map<std::string, std::string>& all() const { return files_; }

 private:
  std::map<std::string, std::string> files_;
  std::map<std::string, std::string> paths_;  // of imported files, by their names
};

// The same options, with what is imported noted in `files`, which sessions share.
[[nodiscard]] SessionOptions noting(SessionOptions options, std::shared_ptr<TakenFiles> files);

}  // namespace armlet::lab
