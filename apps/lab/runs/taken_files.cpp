#include "taken_files.hpp"

#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace armlet::lab {
namespace {

std::string clean(const std::filesystem::path& path) {
  return path.lexically_normal().generic_string();
}

// "points.csv" of "load points.csv"; empty if it is another question.
std::string_view rest_of(std::string_view question, std::string_view word) {
  return question.starts_with(word) ? question.substr(word.size()) : std::string_view();
}

// The path of a mesh of a link that is requested as "link1.glb of arms/arm.urdf", or as "link1.glb
// of " by the program itself. A mesh outside of the folder, with its package, is searched for
// inside (find_mesh).
std::string path_of_mesh(std::string_view asked) {
  const std::size_t of = asked.rfind(" of ");
  std::string_view mesh = asked.substr(0, of);
  for (const std::string_view scheme : {"package://", "file://"}) {
    if (mesh.starts_with(scheme)) mesh.remove_prefix(scheme.size());
  }
  const std::filesystem::path folder = std::filesystem::path(asked.substr(of + 4)).parent_path();
  std::string path = clean(folder / mesh);
  while (path.starts_with("../")) path.erase(0, 3);
  return path;
}

}  // namespace

void TakenFiles::add_import(const std::string& path, const std::string& from,
                            const ImportedText& given) {
  if (!given.text) return;
  const auto importing = paths_.find(from);
  const std::filesystem::path folder = importing == paths_.end()
                                           ? std::filesystem::path()
                                           : std::filesystem::path(importing->second).parent_path();
  const std::string inside = clean(folder / path);
  paths_.insert_or_assign(given.name, inside);
  files_.insert_or_assign(inside, *given.text);
}

void TakenFiles::add_loaded(const SessionLog& log) {
  for (const LoggedEntry& entry : log.entries) {
    std::set<std::string, std::less<>> saved;
    for (const Reply& reply : entry.replies) {
      if (reply.error) continue;
      // "save NAME HASH": the hash has 16 digits.
      const std::string_view save = rest_of(reply.question, "save ");
      if (save.size() > 17) saved.emplace(save.substr(0, save.size() - 17));
      const std::string_view mesh = rest_of(reply.question, "glb ");
      if (!mesh.empty()) files_.insert_or_assign(path_of_mesh(mesh), reply.text);
      const std::string_view load = rest_of(reply.question, "load ");
      if (load.empty() || saved.contains(load)) continue;
      files_.insert_or_assign(clean(std::filesystem::path(load)), reply.text);
    }
  }
}

SessionOptions noting(SessionOptions options, std::shared_ptr<TakenFiles> files) {
  if (!options.load) return options;
  options.load = [inner = std::move(options.load), files = std::move(files)](
                     const std::string& path, const std::string& from) {
    ImportedText given = inner(path, from);
    files->add_import(path, from, given);
    return given;
  };
  return options;
}

}  // namespace armlet::lab
