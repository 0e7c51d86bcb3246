#pragma once
// Files, read and written so that nothing is surprised: below a folder no link is followed and no
// name leads out, what is not a regular file is refused, and a file that cannot be written to its
// end leaves the one before as it was.
//
// Reasons are parts of a sentence without an end: "there is no such file". Codes of errors:
// missing (the file, or a folder on the way), outside, link, kind (no regular file), large, name,
// system (what the system says).

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

// Writes some of the bytes to an open file, as write(2) does: how many, or -1 with errno set.
using WriteBytes = long (*)(int file, const void* bytes, std::size_t count);

// A file that comes into being all at once: it is written beside its name and takes its place in
// `finish`. Unless that succeeds what had the name before stays as it was, and nothing else is
// left. A file that is replaced gives the new one its permissions and owner.
class NewFile {
 public:
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&& other) noexcept;
  ~NewFile();

  // False: it failed, now or before; `finish` says why.
  bool write(std::string_view bytes);
  // What is written next goes over the bytes from `offset` on. False as from `write`.
  bool seek(std::uint64_t offset);
  // The reason if the file could not be written to its end and put in its place.
  [[nodiscard]] std::optional<Error> finish();

 private:
  friend class Folder;
  struct Open;
  explicit NewFile(std::unique_ptr<Open> open);
  std::unique_ptr<Open> open_;
};

// A folder that is held open: it stays the same one whatever becomes of its name. Names of files
// are relative to it, with / between folders; a name from the root is understood if it begins with
// the folder's own. `..` leads up to the folder itself and no farther.
class Folder {
 public:
  // Links on the way to the folder are followed. An empty path is the working folder.
  [[nodiscard]] static Result<Folder> open(const std::string& path);
  Folder(Folder&& other) noexcept;
  Folder& operator=(Folder&& other) noexcept;
  ~Folder();

  // most  bytes; a larger file is refused.
  [[nodiscard]] Result<std::string> read(std::string_view name, std::size_t most) const;
  [[nodiscard]] bool has_file(std::string_view name) const;
  // The names in a folder that end so, sorted; nothing if it cannot be read. At most 1000.
  [[nodiscard]] std::vector<std::string> names(std::string_view folder,
                                               std::string_view ending) const;

  // write  null: as the system does.
  [[nodiscard]] Result<NewFile> create(std::string_view name, WriteBytes write = nullptr) const;
  // The reason if it could not be written.
  [[nodiscard]] std::optional<Error> save(std::string_view name, std::string_view content,
                                          WriteBytes write = nullptr) const;
  // The name without . and .. and double /; an error if it is none or leads out.
  [[nodiscard]] Result<std::string> clean(std::string_view name) const;

 private:
  struct Place;
  explicit Folder(int handle, std::string path);
  [[nodiscard]] Result<Place> place_of(std::string_view name) const;

  int handle_ = -1;
  std::string path_;  // without links
};

// The same for files that a person named: links are followed.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t most);
[[nodiscard]] Result<NewFile> create_file(const std::string& path, WriteBytes write = nullptr);
// The text that comes through an open file which may be a pipe; waits for its end.
[[nodiscard]] Result<std::string> read_all(int file, std::size_t most);
// Whether both names stand for one file that exists.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);
// The path from the root, without links, . and .. as far as it exists.
[[nodiscard]] std::string real_path(const std::string& path);
// Whether a regular file has this path, links being followed.
[[nodiscard]] bool is_file(const std::string& path);

// Takes away what unfinished files of this process have left beside their names. For signal
// handlers that end the process.
void remove_unfinished_files() noexcept;

// A NewFile as a stream, for those who write to one. It does not finish the file.
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
