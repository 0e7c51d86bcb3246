// Files of a program: only below the folder that the host allows (language reference,
// section 17.1).

#include "armlet/core/files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/mesh/glb.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/stdlib/host.hpp"
#include "host/journal.hpp"

namespace armlet {
namespace {

namespace fs = std::filesystem;

Error refuse(std::string why) { return Error{"file", std::move(why)}; }

// The error in words for a program, which does not know the host's folders.
Error refusal(const Error& error, std::string_view does) {
  if (error.code != "outside") return refuse(error.message);
  return refuse(fmt::format("programs {} files only below their own folder", does));
}

// A mesh of a package that the host allows; it need not be below the program's folder.
Result<std::string> read_package_mesh(const HostOptions& options, const std::string& path,
                                      double unit) {
  const std::string folder = fs::path(path).parent_path().string();
  const std::string name = fs::path(path).filename().string();
  if (!is_glb_name(name) && options.convert_mesh && !mesh_format(name).empty())
    return options.convert_mesh(folder, name, unit, options.is_cancelled);
  if (!is_glb_name(name))
    return Error{"converter", "this host reads GLB alone; make one of it with armlet mesh convert"};
  const Result<Folder> opened = Folder::open(folder);
  if (!opened.ok()) return refuse("the folder of the package cannot be opened");
  return opened->read(name, kMostGlbBytes);
}

}  // namespace

Result<fs::path> Host::write(const FileKind& kind, const std::string& name,
                             std::string_view content) const {
  if (options_.folder.empty()) return refuse("this host lets programs write no files");
  const auto ends_so = [&](std::string_view ending) { return name.ends_with(ending); };
  if (!name.empty() && std::ranges::none_of(kind.endings, ends_so)) {
    return refuse(fmt::format("{} is a {} file", kind.what, fmt::join(kind.endings, " or ")));
  }
  const std::string_view last = std::string_view(name).substr(name.find_last_of('/') + 1);
  if (std::ranges::find(kind.endings, last) != kind.endings.end())
    return refuse(fmt::format("a name before {} is missing", last));
  const Result<Folder> folder = Folder::open(options_.folder.string());
  if (!folder.ok()) return refuse("the folder of the program cannot be opened");
  const Result<std::string> clean = folder->clean(name);
  if (!clean.ok()) return refusal(clean.error(), "write");
  const bool keeps = options_.journal == nullptr || options_.journal->keeps_files();
  const auto error = keeps ? folder->save(*clean, content) : std::nullopt;
  if (error) return refusal(*error, "write");
  return options_.folder / *clean;
}

Result<std::string> Host::read(const std::string& name, std::size_t most) const {
  if (folder_of_files().empty()) return refuse("this host lets programs read no files");
  const Result<Folder> folder = Folder::open(folder_of_files().string());
  if (!folder.ok()) return refuse("the folder of the program cannot be opened");
  Result<std::string> text = folder->read(name, most);
  if (!text.ok()) return refusal(text.error(), "read");
  return text;
}

Result<std::string> Host::read_mesh(const std::string& name, double unit) const {
  if (is_glb_name(name)) {
    if (unit != 0.0 && unit != 1.0) return refuse("GLB is in metres; it takes no other unit");
    return read(name, kMostGlbBytes);
  }
  // A file with another name may contain a GLB; read_glb fails if it does not.
  if (mesh_format(name).empty()) return read(name, kMostGlbBytes);
  if (folder_of_files().empty()) return refuse("this host lets programs read no files");
  if (!options_.convert_mesh) {
    // Files that came with an exported laboratory are GLB under the name that the program uses.
    Result<std::string> bytes = read(name, kMostGlbBytes);
    if (!bytes.ok() || bytes->starts_with("glTF")) return bytes;
    return Error{"converter", "this host reads GLB alone; make one of it with armlet mesh convert"};
  }
  const Result<std::string> glb =
      options_.convert_mesh(folder_of_files().string(), name, unit, options_.is_cancelled);
  if (!glb.ok() && glb.error().code == "outside") return refusal(glb.error(), "read");
  return glb;
}

std::string Host::mesh_path(const std::string& file, const std::string& mesh) const {
  if (folder_of_files().empty()) return {};
  const fs::path folder = (folder_of_files() / file).parent_path();
  const fs::path from = file.empty() ? folder_of_files() : folder;
  return find_mesh(from.string(), folder_of_files().string(), mesh, options_.packages);
}

bool Host::finds_mesh(const std::string& file, const std::string& mesh) const {
  return !mesh_path(file, mesh).empty();
}

// ---- through the journal

namespace {

template <class T>
Reply reply_of(const Result<T>& result) {
  Reply reply;
  if (result.ok()) {
    if constexpr (std::is_same_v<T, fs::path>) {
      reply.text = result->string();
    } else {
      reply.text = *result;
    }
  } else {
    reply.error = result.error();
  }
  return reply;
}

}  // namespace

Result<fs::path> Host::save_file(const FileKind& kind, const std::string& name,
                                 std::string_view content) const {
  if (options_.journal == nullptr) return write(kind, name, content);
  const Reply reply =
      options_.journal->save(name, content, [&] { return reply_of(write(kind, name, content)); });
  if (reply.error) return *reply.error;
  return fs::path(reply.text);
}

Result<std::string> Host::load_file(const std::string& name, std::size_t most) const {
  if (options_.journal == nullptr) return read(name, most);
  Reply reply = options_.journal->load(name, [&] { return reply_of(read(name, most)); });
  if (reply.error) return *reply.error;
  return std::move(reply.text);
}

Result<std::string> Host::load_mesh(const std::string& file, const std::string& mesh,
                                    double unit) const {
  const auto read_it = [&]() -> Result<std::string> {
    const std::string path = mesh_path(file, mesh);
    if (path.empty()) return refuse("there is no such file");
    const fs::path below = fs::path(path).lexically_relative(real_path(folder_of_files().string()));
    if (below.empty() || *below.begin() == "..") return read_package_mesh(options_, path, unit);
    return read_mesh(path, unit);
  };
  if (options_.journal == nullptr) return read_it();
  Reply reply = options_.journal->ask(fmt::format("glb {} of {}", mesh, file),
                                      [&] { return reply_of(read_it()); });
  if (reply.error) return *reply.error;
  return std::move(reply.text);
}

Result<std::string> Host::load_shape(const std::string& name, double unit) const {
  const std::string key = fmt::format("{} in units of {}", name, unit);
  if (const auto known = world_meshes_.find(key); known != world_meshes_.end())
    return known->second;
  Result<std::string> glb = [&]() -> Result<std::string> {
    if (options_.journal == nullptr) return read_mesh(name, unit);
    Reply reply = options_.journal->load(name, [&] { return reply_of(read_mesh(name, unit)); });
    if (reply.error) return *reply.error;
    return std::move(reply.text);
  }();
  // A scene has many parts in one file.
  if (fills_world_ && glb.ok()) world_meshes_.emplace(key, *glb);
  return glb;
}

std::optional<Result<std::string>> Host::host_frame(const FrameRequest& asked) const {
  const HostFrames& frames = options_.frames;
  if (std::ranges::find(frames.cameras, asked.camera) == frames.cameras.end()) return std::nullopt;
  const auto take = [&]() -> Result<std::string> {
    if (frames.take) return frames.take(asked);
    return Error{"frames", "the log of the run has no more of them"};
  };
  if (options_.journal == nullptr) return take();
  Reply reply = options_.journal->ask(fmt::format("frame {} of {}", asked.number, asked.camera),
                                      [&] { return reply_of(take()); });
  if (reply.error) return *reply.error;
  return std::move(reply.text);
}

bool Host::has_mesh(const std::string& file, const std::string& mesh) const {
  if (options_.journal == nullptr) return finds_mesh(file, mesh);
  const auto outside = [&] {
    return Reply{.question = {}, .text = finds_mesh(file, mesh) ? "yes" : "no"};
  };
  return options_.journal->ask(fmt::format("mesh {} of {}", mesh, file), outside).text == "yes";
}

}  // namespace armlet
