#include "client/cache.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "client/sha256.hpp"

namespace armlet::mesh {
namespace {

constexpr std::string_view kFirstLine = "armlet mesh names 1\n";
constexpr std::size_t kMostNames = std::size_t{1} << 20;  // bytes

// The text up to the end of its line, which is taken away with it; nothing if no line ends.
std::optional<std::string> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string line(text.substr(0, end));
  text.remove_prefix(end + 1);
  return line;
}

}  // namespace

std::string hash_of(const Sibling& sibling) {
  Sha256 hash;
  hash.add_text(std::string(1, static_cast<char>(sibling.state)));
  hash.add_text(sibling.text);
  return hash.digits();
}

Cache::Cache(std::string folder, std::string key) : key_(std::move(key)) {
  if (folder.empty()) return;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  Result<Folder> opened = Folder::open(folder);
  if (opened.ok()) folder_.emplace(std::move(opened).value());
}

std::string Cache::result_name(const std::vector<Asked>& asked) const {
  Sha256 hash;
  hash.add_text(key_);
  for (const Asked& each : asked) {
    hash.add_text(each.name);
    hash.add_text(each.hash);
  }
  return hash.digits() + ".glb";
}

std::optional<std::string> Cache::find(
    const std::function<Sibling(const std::string& name)>& find) const {
  if (!folder_) return std::nullopt;
  const Result<std::string> names = folder_->read(key_ + ".names", kMostNames);
  if (!names.ok() || !names->starts_with(kFirstLine)) return std::nullopt;
  std::string_view text(*names);
  text.remove_prefix(kFirstLine.size());
  const auto wanted = take_line(text);
  if (!wanted) return std::nullopt;
  std::vector<Asked> asked;
  while (!text.empty()) {
    auto name = take_line(text);
    if (!name) return std::nullopt;
    asked.push_back({*name, hash_of(find(*name))});
  }
  Result<std::string> glb = folder_->read(result_name(asked), ConvertLimits{}.result);
  if (!glb.ok() || sha256(*glb) != *wanted) return std::nullopt;
  return std::move(glb).value();
}

void Cache::keep(const std::vector<Asked>& asked, const std::string& glb) const {
  if (!folder_) return;
  std::string names(kFirstLine);
  names += sha256(glb) + "\n";
  for (const Asked& each : asked) {
    if (each.name.find('\n') != std::string::npos) return;
    names += each.name + "\n";
  }
  // The result first: whoever reads the names finds it.
  if (folder_->save(result_name(asked), glb)) return;
  (void)folder_->save(key_ + ".names", names);
}

}  // namespace armlet::mesh
