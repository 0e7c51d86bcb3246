#pragma once
// How a text is compiled: limits, what it may import, what it goes on from.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet {

class Program;
struct WorldNames;
class TableFiles;

struct ParseLimits {
  std::uint32_t bytes = 16U << 20U;
  std::uint32_t tokens = 4'000'000;
  std::uint32_t nesting = 200;
  int errors = 10;
};

// What a host answers to `import "path"`.
struct ImportedText {
  std::string name;                 // of the file in messages; one file has one name
  std::optional<std::string> text;  // nothing: there is no such file, or it is not to be read
  std::string why;                  // with no text: the reason, if there is more to say
  std::vector<std::string> others;  // with no text: the paths that exist, for "did you mean"
};
// `path` is what the program says, `from` the name of the file that says it.
using ModuleLoader = std::function<ImportedText(const std::string& path, const std::string& from)>;

struct CompileOptions {
  ParseLimits limits;
  void* host = nullptr;  // handed to check rules
  // What rules may know of the world by name (world_names.hpp); null: nothing.
  std::shared_ptr<const WorldNames> world{};
  ModuleLoader load;  // nothing can be imported without it
  // For editors: the texts that a parameter of a library function may hold, as far as the host
  // knows them, such as names of things in its world. Null: none.
  std::function<std::vector<std::string>(const NativeFunction&, std::string_view parameter)> texts;
  // The host can read and set the program's variables by name. Where nobody asks for them, those
  // that only the top level uses lie in registers.
  bool open = true;
  bool markers = false;  // for debuggers: run by statements (host/stepping.hpp), and more slowly
  // The text may only declare things by blocks of these types, `object`, and constants; empty:
  // anything. `refuse` makes the message for another statement.
  std::vector<std::string_view> only_blocks{};
  std::function<Diagnostic(Span statement)> refuse{};
  // The text is an entry of a session: its names stay for entries behind it, and the value of an
  // expression at its end is kept as `ans`.
  bool is_entry = false;
  // The newest entry of the session, in whose scope the text is compiled; it implies is_entry.
  // Null: the text is the first one.
  std::shared_ptr<const Program> after{};
  // Set to true by the host, from any thread: compiling ends soon, without a program and with the
  // message R0629 alone.
  const std::atomic<bool>* cancelled = nullptr;
  // The compiler's own: tables that the program reads, as its checks found them.
  std::shared_ptr<TableFiles> tables{};
};

}  // namespace armlet
