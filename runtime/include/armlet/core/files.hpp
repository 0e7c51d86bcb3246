#pragma once
// Safe reading and writing of files. Below a folder no link is followed and no name leads outside,
// only regular files are accepted, and a file that cannot be written completely leaves the former
// one unchanged.
//
// Reasons are parts of a sentence without a full stop: "there is no such file". Codes of errors:
// missing (the file, or a folder of its path), outside, link, kind (not a regular file), large,
// name, system (the system's message).

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"

namespace armlet {

// Writes some of the bytes to an open file, as write(2) does; returns their number, or -1 with
// errno set.
using WriteBytes = long (*)(int file, const void* bytes, std::size_t count);

// A file that is replaced atomically: it is written under a temporary name and renamed in `finish`.
// Unless that succeeds the former file is unchanged, and no other file remains. The new file gets
// the permissions and the owner of the former one.
class NewFile {
 public:
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&& other) noexcept;
  ~NewFile();

  // Writes bytes; false: this or an earlier call failed, and `finish` returns the reason.
  bool write(std::string_view bytes);
  // The next write overwrites the bytes from `offset` on. False as from `write`.
  bool seek(std::uint64_t offset);
  // The path of the unfinished file, with the ending of its final name, for libraries that write
  // files by name; empty after `finish` and on platforms without a file system.
  [[nodiscard]] std::string path() const;
  // Completes the file; returns the reason if it could not be written completely and renamed.
  [[nodiscard]] std::optional<Error> finish();

 private:
  friend class Folder;
  struct Open;
  explicit NewFile(std::unique_ptr<Open> open);
  std::unique_ptr<Open> open_;
};

// A folder that is held open: it stays the same folder when it is renamed. Names of files are
// relative to it, with / between folders; an absolute name is accepted if it begins with the
// folder's own path. `..` never leads above the folder itself.
class Folder {
 public:
  // Links in the path to the folder are followed. An empty path is the working folder.
  [[nodiscard]] static Result<Folder> open(const std::string& path);
  Folder(Folder&& other) noexcept;
  Folder& operator=(Folder&& other) noexcept;
  ~Folder();

  // most  bytes; a larger file is refused.
  [[nodiscard]] Result<std::string> read(std::string_view name, std::size_t most) const;
  [[nodiscard]] bool has_file(std::string_view name) const;
  // The names in a folder with this ending, sorted; none if it cannot be read. At most 1000.
  [[nodiscard]] std::vector<std::string> names(std::string_view folder,
                                               std::string_view ending) const;

  // write  null: write(2).
  [[nodiscard]] Result<NewFile> create(std::string_view name, WriteBytes write = nullptr) const;
  // Writes a file; returns the reason if it failed.
  [[nodiscard]] std::optional<Error> save(std::string_view name, std::string_view content,
                                          WriteBytes write = nullptr) const;
  // The name without . and .. and double /; an error if it is not a name or leads outside.
  [[nodiscard]] Result<std::string> clean(std::string_view name) const;

 private:
  struct Place;
  explicit Folder(int handle, std::string path);
  [[nodiscard]] Result<Place> place_of(std::string_view name) const;

  int handle_ = -1;
  std::string path_;  // without links
};

// Reads a file that a user named: links are followed.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t most);
[[nodiscard]] Result<NewFile> create_file(const std::string& path, WriteBytes write = nullptr);
// Reads text from an open file, which may be a pipe, up to its end.
[[nodiscard]] Result<std::string> read_all(int file, std::size_t most);
// Whether both names denote the same existing file.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);
// The absolute path, without links, . and .. as far as it exists.
[[nodiscard]] std::string real_path(const std::string& path);
// Whether this path is a regular file; links are followed.
[[nodiscard]] bool is_file(const std::string& path);

// Removes temporary files that unfinished writes of this process have left. For signal handlers
// that end the process.
void remove_unfinished_files() noexcept;

// A NewFile as a stream. It does not finish the file.
class FileStream : public std::ostream {
 public:
  explicit FileStream(NewFile& file) : std::ostream(nullptr), buffer_(file) { rdbuf(&buffer_); }

 private:
  class Buffer : public std::streambuf {
   public:
    explicit Buffer(NewFile& file) : file_(file) {}

   private:
    std::streamsize xsputn(const char* bytes, std::streamsize count) override;
    int_type overflow(int_type byte) override;
    pos_type seekpos(pos_type position, std::ios_base::openmode which) override;

    NewFile& file_;
  };
  Buffer buffer_;
};

}  // namespace armlet
