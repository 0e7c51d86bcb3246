// Files of a program: only below the folder that the host grants (language reference, ruling 34).

#include <fmt/format.h>

#include <fstream>

#include "armlet/stdlib/host.hpp"

namespace armlet {
namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != ".." && *relative.begin() != ".";
}

Error refuse(std::string why) { return Error{"file", std::move(why)}; }

}  // namespace

Result<fs::path> Host::save_file(const std::string& name, std::string_view content) const {
  if (options_.folder.empty()) return refuse("this host lets programs write no files");
  if (name.empty()) return refuse("the name of the file is empty");
  std::error_code problem;
  const fs::path folder = fs::weakly_canonical(options_.folder, problem);
  // Links are followed, so that none leads out of the folder.
  const fs::path file = fs::weakly_canonical(folder / name, problem);
  if (problem || !is_below(file, folder))
    return refuse("programs write files only below their own folder");
  if (fs::is_directory(file, problem)) return refuse("there is a folder of that name");
  if (!fs::is_directory(file.parent_path(), problem)) {
    return refuse(fmt::format("there is no folder \"{}\" in the folder of the program",
                              file.parent_path().lexically_relative(folder).string()));
  }
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) return refuse("the file cannot be written");
  return file;
}

}  // namespace armlet
