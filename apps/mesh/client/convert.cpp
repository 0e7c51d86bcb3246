#include "client/convert.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "armlet/core/platform.hpp"
#include "armlet/mesh/glb.hpp"
#include "client/cache.hpp"
#include "client/process.hpp"
#include "client/sha256.hpp"
#include "client/siblings.hpp"

namespace armlet::mesh {
namespace {

constexpr std::size_t kMostProgram = std::size_t{64} << 20;  // bytes of the converter program

// The files that a mesh has requested, each read once.
class Answers {
 public:
  Answers(const Siblings& siblings, const ConvertLimits& limits)
      : siblings_(siblings), limits_(limits) {}

  Sibling find(const std::string& name) {
    const auto known = found_.find(name);
    if (known != found_.end()) return known->second;
    if (static_cast<int>(found_.size()) >= limits_.files)
      return {Say::kUnusable, fmt::format("the mesh names more than {} files", limits_.files)};
    Sibling sibling = siblings_.find(name, limits_.file);
    if (sibling.state == Say::kFile) {
      bytes_ += sibling.text.size();
      if (bytes_ > 2 * limits_.file)
        sibling = {Say::kUnusable,
                   fmt::format("the files of the mesh have more than {} MB", limits_.file >> 19)};
    }
    return found_.emplace(name, std::move(sibling)).first->second;
  }

  [[nodiscard]] std::vector<Asked> asked() const {
    std::vector<Asked> all;
    for (const auto& [name, sibling] : found_) all.push_back({name, hash_of(sibling)});
    return all;
  }

 private:
  const Siblings& siblings_;
  const ConvertLimits& limits_;
  std::map<std::string, Sibling> found_;
  std::size_t bytes_ = 0;
};

std::string key_of(const std::string& converter, const std::vector<std::string>& arguments,
                   const std::string& input) {
  const Result<std::string> program = read_file(converter, kMostProgram);
  Sha256 hash;
  hash.add_text(program.ok() ? *program : std::string());
  for (const std::string& each : arguments) hash.add_text(each);
  hash.add_text(input);
  return hash.digits();
}

}  // namespace

Result<std::string> convert_mesh(const Folder& folder, const std::string& path,
                                 const std::string& name, const ConvertOptions& options) {
  const std::string_view format = mesh_format(name);
  if (format.empty()) {
    return Error{"format",
                 fmt::format("its name ends in no format that is read: {}", kMeshFormats)};
  }
  const std::string converter = options.converter.empty() ? find_converter() : options.converter;
  if (converter.empty()) return Error{"converter", no_converter()};
  const Result<std::string> clean = folder.clean(name);
  if (!clean.ok()) return clean.error();
  const Result<std::string> input = folder.read(*clean, options.limits.file);
  if (!input.ok()) return input.error();
  const std::size_t slash = clean->rfind('/');
  const Siblings siblings(folder, path,
                          slash == std::string::npos ? "" : clean->substr(0, slash + 1));
  const std::string own = slash == std::string::npos ? *clean : clean->substr(slash + 1);
  ConverterRun run;
  run.program = converter;
  run.arguments = {std::string(format), fmt::format("{}", options.unit),
                   options.up == 0 ? "-" : std::string(1, options.up), own};
  const Cache cache(options.cache, key_of(converter, run.arguments, *input));
  {
    Answers answers(siblings, options.limits);
    if (auto glb = cache.find([&](const std::string& each) { return answers.find(each); }))
      return std::move(*glb);
  }
  Answers answers(siblings, options.limits);
  run.input = *input;
  run.find = [&](const std::string& each) { return answers.find(each); };
  run.progress = options.progress;
  run.is_cancelled = options.is_cancelled;
  run.limits = options.limits;
  Result<std::string> glb = run_converter(run);
  if (glb.ok()) cache.keep(answers.asked(), *glb);
  return glb;
}

Result<std::string> convert_mesh(const std::string& file, const ConvertOptions& options) {
  const std::string real = real_path(file);
  const std::size_t slash = real.rfind('/');
  const std::string path =
      slash == std::string::npos ? std::string(".") : real.substr(0, slash + 1);
  const Result<Folder> folder = Folder::open(path);
  if (!folder.ok()) return folder.error();
  return convert_mesh(*folder, path, slash == std::string::npos ? real : real.substr(slash + 1),
                      options);
}

std::string mesh_cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && cache[0] == '/') return fmt::format("{}/armlet/meshes", cache);
  const char* home = std::getenv("HOME");
  if (home != nullptr && home[0] == '/') return fmt::format("{}/.cache/armlet/meshes", home);
  return {};
}

std::string find_converter() {
  const std::string folder = program_folder();
  for (const char* const place : {"/armlet-mesh", "/../lib/armlet-mesh"}) {
    if (is_file(folder + place)) return folder + place;
  }
  return {};
}

std::string no_converter() {
  return "it takes the converter armlet-mesh, which is not there: install libassimp-dev, "
         "libcoin-dev and libtinyxml2-dev, build it with `./dev build`, and keep it beside armlet; "
         "or "
         "convert the mesh to GLB elsewhere";
}

}  // namespace armlet::mesh
