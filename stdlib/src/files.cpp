// Files of a program: only below the folder that the host grants (language reference, ruling 34).

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>

#include "armlet/model/urdf.hpp"
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

Result<std::string> Host::load_file(const std::string& name) const {
  constexpr std::uintmax_t kMaxBytes = 16 << 20;
  if (options_.folder.empty()) return refuse("this host lets programs read no files");
  std::error_code problem;
  const fs::path folder = fs::weakly_canonical(options_.folder, problem);
  const fs::path file = fs::weakly_canonical(folder / name, problem);
  if (problem || !is_below(file, folder))
    return refuse("programs read files only below their own folder");
  if (!fs::exists(file, problem)) return refuse("there is no such file");
  if (!fs::is_regular_file(file, problem)) return refuse("it is no file");
  if (fs::file_size(file, problem) > kMaxBytes) return refuse("it is larger than 16 MB");
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.good() && !in.eof()) return refuse("reading failed");
  return text;
}

bool Host::has_mesh(const std::string& file, const std::string& mesh) const {
  if (options_.folder.empty()) return false;
  const fs::path folder = (options_.folder / file).parent_path();
  const fs::path from = file.empty() ? options_.folder : folder;
  return !find_mesh(from.string(), options_.folder.string(), mesh).empty();
}

}  // namespace armlet
