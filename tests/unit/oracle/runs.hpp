// The programs that the laws of runs are tested with.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet::runs {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline ModuleLoader files_beside(const fs::path& folder) {
  return [folder](const std::string& path, const std::string& from) {
    const fs::path file = (folder / fs::path(from).parent_path() / path).lexically_normal();
    ImportedText out;
    if (!fs::exists(file)) return out;
    out.name = fs::relative(file, folder).string();
    out.text = text_of(file);
    return out;
  };
}

// The programs below a folder of the tree, sorted, that a test has the time to run.
inline std::vector<fs::path> programs_below(const char* folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ARMLET_ROOT) / folder)) {
    const bool is_module = entry.path().string().find("/modules/") != std::string::npos;
    // They run some seventy times. One drives for three years, of which every 10 ms would be
    // reported; the others draw 100 pictures and more, as fig18d_7dof_ibvs.rbt does on a small
    // scale.
    static constexpr std::string_view kLong[] = {"end_of_time.rbt", "07_visual_servo.rbt",
                                                 "fig16_ibvs.rbt",  "24_camera_window.rbt",
                                                 "hand_eye.rbt",    "sort_by_sight.rbt"};
    const bool is_long =
        std::ranges::find(kLong, entry.path().filename().string()) != std::end(kLong);
    if (entry.path().extension() == ".rbt" && !is_module && !is_long) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

inline std::uint64_t number_from(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace armlet::runs
