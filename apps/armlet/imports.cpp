#include "imports.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "files.hpp"

namespace fs = std::filesystem;

namespace armlet::cli {
namespace {

bool lies_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

class ProgramFolder {
 public:
  explicit ProgramFolder(const std::string& program)
      : shown_(program.substr(0, program.find_last_of('/') + 1)) {
    std::error_code error;
    root_ = fs::canonical(shown_.empty() ? "." : shown_, error);
  }

  ImportedText load(const std::string& path, const std::string& from) const {
    const fs::path folder = fs::path(from).parent_path();
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder / path, error);
    ImportedText out;
    if (error || root_.empty() || !lies_below(file, root_) || fs::path(path).is_absolute()) {
      out.why = "files are imported from the folder of the program and those below it";
      return out;
    }
    if (file.extension() == ".rbt" && fs::is_regular_file(file, error)) {
      std::string reason;
      out.text = read_text(file.string(), reason);
      out.why = reason;
      out.name = shown_ + fs::relative(file, root_, error).string();
      return out;
    }
    if (fs::is_regular_file(file, error)) out.why = "only files that end in .rbt are programs";
    out.others = programs_in(file.parent_path(), fs::path(path).parent_path());
    return out;
  }

 private:
  // As a program would write them.
  static std::vector<std::string> programs_in(const fs::path& folder, const fs::path& before) {
    constexpr std::size_t kMost = 1000;
    std::vector<std::string> names;
    std::error_code error;
    for (auto at = fs::directory_iterator(folder, error);
         !error && at != fs::directory_iterator() && names.size() < kMost; at.increment(error)) {
      if (at->path().extension() == ".rbt")
        names.push_back((before / at->path().filename()).string());
    }
    std::ranges::sort(names);
    return names;
  }

  std::string shown_;  // the folder as the user wrote it, with its last /
  fs::path root_;
};

}  // namespace

ModuleLoader imports_of(const std::string& program) {
  return [folder = ProgramFolder(program)](const std::string& path, const std::string& from) {
    return folder.load(path, from);
  };
}

}  // namespace armlet::cli
