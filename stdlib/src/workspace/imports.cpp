// Imports of a program, from its own folder.

#include <memory>
#include <optional>
#include <utility>

#include "armlet/core/files.hpp"
#include "armlet/interpreter/host/table_text.hpp"
#include "armlet/stdlib/workspace.hpp"

namespace armlet {
namespace {

// The path up to and including the last /.
std::string_view folder_of(std::string_view path) {
  return path.substr(0, path.find_last_of('/') + 1);
}

class ProgramFolder {
 public:
  explicit ProgramFolder(const std::string& program) : shown_(folder_of(program)) {
    Result<Folder> opened = Folder::open(shown_);
    if (opened.ok()) folder_ = std::make_shared<const Folder>(std::move(opened).value());
  }

  ImportedText load(const std::string& path, const std::string& from) const {
    ImportedText out;
    out.why = "files are imported from the folder of the program and those below it";
    if (folder_ == nullptr || path.starts_with('/')) return out;
    const std::string_view inside =
        from.starts_with(shown_) ? std::string_view(from).substr(shown_.size()) : "";
    const std::string name = std::string(folder_of(inside)) + path;
    const Result<std::string> clean = folder_->clean(name);
    if (!clean.ok()) return out;
    out.why.clear();
    const bool is_table = clean->ends_with(kTableEnding);
    if (is_table || clean->ends_with(".rbt")) {
      Result<std::string> text = folder_->read(*clean, ParseLimits{}.bytes);
      if (text.ok()) {
        out.text = std::move(text).value();
        out.name = shown_ + *clean;
        return out;
      }
      if (text.error().code != "missing") {
        out.why = text.error().message;
        return out;
      }
    } else if (folder_->has_file(*clean)) {
      out.why = "only files that end in .rbt are programs";
    }
    // The names as a program would write them.
    const std::string_view ending = is_table ? kTableEnding : ".rbt";
    for (const std::string& other : folder_->names(folder_of(*clean), ending))
      out.others.push_back(std::string(folder_of(path)) + other);
    return out;
  }

 private:
  std::string shown_;  // the folder as the user wrote it, with its last /
  std::shared_ptr<const Folder> folder_;
};

}  // namespace

ModuleLoader imports_of(const std::string& program) {
  return [folder = ProgramFolder(program)](const std::string& path, const std::string& from) {
    return folder.load(path, from);
  };
}

}  // namespace armlet
