// The common part of files on all platforms.
#include "armlet/core/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace armlet {
namespace {

constexpr std::size_t kLongestPath = 4096;  // with the terminating zero

Error because(std::string code, std::string why) { return {std::move(code), std::move(why)}; }

}  // namespace

// ---- Folder -----------------------------------------------------------------------------------

Result<std::string> Folder::clean(std::string_view name) const {
  if (name.empty()) return because("name", "the name of the file is empty");
  if (name.size() >= kLongestPath) {
    return because("name", fmt::format("the name of the file has {} bytes; at most {} are possible",
                                       name.size(), kLongestPath - 1));
  }
  if (name.find('\0') != std::string_view::npos)
    return because("name", "the name of the file holds a zero byte");
  const Error outside = because("outside", "the name leads out of the folder");
  if (name.front() == '/') {
    const std::string below = path_ == "/" ? path_ : path_ + '/';
    if (!name.starts_with(below)) return outside;
    name.remove_prefix(below.size());
  }
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('/', at), name.size());
    const std::string_view part = name.substr(at, end - at);
    at = end + 1;
    if (part.empty() || part == ".") continue;
    if (part != "..") {
      parts.push_back(part);
    } else if (parts.empty()) {
      return outside;
    } else {
      parts.pop_back();
    }
  }
  return fmt::format("{}", fmt::join(parts, "/"));
}

std::optional<Error> Folder::save(std::string_view name, std::string_view content,
                                  WriteBytes write) const {
  Result<NewFile> file = create(name, write);
  if (!file.ok()) return file.error();
  NewFile made = std::move(file).value();
  made.write(content);
  return made.finish();
}

// ---- FileStream -------------------------------------------------------------------------------

std::streamsize FileStream::Buffer::xsputn(const char* bytes, std::streamsize count) {
  return file_.write({bytes, static_cast<std::size_t>(count)}) ? count : 0;
}

FileStream::Buffer::int_type FileStream::Buffer::overflow(int_type byte) {
  if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
  const char letter = traits_type::to_char_type(byte);
  return file_.write({&letter, 1}) ? byte : traits_type::eof();
}

FileStream::Buffer::pos_type FileStream::Buffer::seekpos(pos_type position,
                                                         std::ios_base::openmode) {
  const std::streamoff offset = position;
  const bool done = offset >= 0 && file_.seek(static_cast<std::uint64_t>(offset));
  return done ? position : pos_type(std::streamoff(-1));
}

}  // namespace armlet
