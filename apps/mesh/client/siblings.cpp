#include "client/siblings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace armlet::mesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 1024;
constexpr int kMostSiblings = 10'000;  // most entries of a folder that are compared

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return text;
}

// Decodes percent signs: "Tex%201.png" is "Tex 1.png".
std::string percent_read(std::string_view name) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '%' && i + 2 < name.size() && digit(name[i + 1]) >= 0 &&
        digit(name[i + 2]) >= 0) {
      out += static_cast<char>(digit(name[i + 1]) * 16 + digit(name[i + 2]));
      i += 2;
    } else {
      out += name[i];
    }
  }
  return out;
}

// Whether the name begins with "http:" or "C:".
bool has_scheme(std::string_view name) {
  if (name.empty() || !is_letter(name.front())) return false;
  for (const char c : name) {
    if (c == ':') return true;
    if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') return false;
  }
  return false;
}

}  // namespace

Result<std::string> sibling_name(std::string_view name) {
  const auto out = [](const char* why) { return Error{"outside", why}; };
  if (name.size() > kLongestName) return Error{"name", "its name is too long"};
  if (std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; }))
    return Error{"name", "its name has a control character"};
  std::string path(name);
  std::replace(path.begin(), path.end(), '\\', '/');
  if (has_scheme(path))
    return out("it lies on a drive or in a network; files beside the mesh are read");
  if (path.starts_with('/'))
    return out("its name begins at a root; files beside the mesh are read");
  std::string clean;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string part = path.substr(at, end - at);
    at = end + 1;
    if (part.empty() || part == ".") continue;
    if (part == "..") return out("its name leads out of the folder of the mesh");
    clean += (clean.empty() ? "" : "/") + part;
  }
  if (clean.empty()) return Error{"name", "it has no name"};
  return clean;
}

Sibling Siblings::find(std::string_view asked, std::size_t most) const {
  std::string read_as = percent_read(asked);
  for (const std::string& written : {std::string(asked), read_as}) {
    const Result<std::string> name = sibling_name(written);
    if (!name.ok()) {
      return {name.error().code == "outside" ? Say::kOutside : Say::kUnusable,
              name.error().message};
    }
    Sibling found = read(*name, most);
    if (found.state != Say::kAbsent) return found;
    const std::string other = in_another_case(*name);
    if (!other.empty()) found = read(other, most);
    if (found.state != Say::kAbsent) return found;
    if (written == read_as) break;
  }
  return {Say::kAbsent, "there is no such file beside the mesh"};
}

Sibling Siblings::read(const std::string& name, std::size_t most) const {
  Result<std::string> bytes = folder_.read(below_ + name, most);
  if (bytes.ok()) return {Say::kFile, std::move(bytes).value()};
  const Error& error = bytes.error();
  return {error.code == "missing" ? Say::kAbsent : Say::kUnusable, error.message};
}

std::string Siblings::in_another_case(const std::string& name) const {
  std::string found;
  fs::path at = fs::path(path_) / below_;
  for (const fs::path& part : fs::path(name)) {
    std::error_code failed;
    if (fs::is_symlink(fs::symlink_status(at, failed)) && !found.empty()) return {};
    const std::string wanted = lower(part.string());
    std::vector<std::string> matching;
    int seen = 0;
    for (fs::directory_iterator each(at, failed), end; !failed && each != end;
         each.increment(failed)) {
      if (++seen > kMostSiblings) break;
      std::string other = each->path().filename().string();
      if (lower(other) == wanted) matching.push_back(std::move(other));
    }
    if (matching.empty()) return {};
    const std::string next = *std::min_element(matching.begin(), matching.end());
    at /= next;
    found += (found.empty() ? "" : "/") + next;
  }
  return found == name ? std::string() : found;
}

}  // namespace armlet::mesh
