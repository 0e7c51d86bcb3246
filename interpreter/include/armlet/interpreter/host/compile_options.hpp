#pragma once
// Options of the compiler: limits, imports, the entry before.

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

// The answer of a host to `import "path"`.
struct ImportedText {
  std::string name;  // of the file, in messages; the same for each import of the file
  std::optional<std::string> text;  // empty: the file does not exist or must not be read
  std::string why;                  // without a text: the reason, if there is one to show
  std::vector<std::string> others;  // without a text: paths that exist, for "did you mean"
};
// `path` is the text in the program, `from` the name of the importing file.
using ModuleLoader = std::function<ImportedText(const std::string& path, const std::string& from)>;

struct CompileOptions {
  ParseLimits limits;
  void* host = nullptr;  // passed to rules that check calls
  // The names of the world, for rules (world_names.hpp); null: none are known.
  std::shared_ptr<const WorldNames> world{};
  ModuleLoader load;  // without it imports fail
  // For editors: the texts that are possible for a parameter of a library function, such as names
  // of objects in the host's world. Null: none are known.
  std::function<std::vector<std::string>(const NativeFunction&, std::string_view parameter)> texts;
  // Whether the host can read and set the program's global variables by name. Otherwise those that
  // only the top level uses are kept in registers.
  bool open = true;
  // For debuggers: allows runs by statements (host/stepping.hpp), but is slower.
  bool markers = false;
  // The types of blocks that the text may declare, besides `object` and constants, without any
  // other statement; empty: no restriction. `refuse` makes the message for another statement.
  std::vector<std::string_view> only_blocks{};
  std::function<Diagnostic(Span statement)> refuse{};
  // The text is an entry of a session: later entries can use its names, and the value of an
  // expression at its end becomes `ans`.
  bool is_entry = false;
  // The newest entry of the session, whose names the text can use; it implies is_entry. Null: the
  // text is the first entry.
  std::shared_ptr<const Program> after{};
  // Set to true by the host, in any thread: the compiler then soon returns no program and only the
  // message R0629.
  const std::atomic<bool>* cancelled = nullptr;
  // Internal: the tables that the program loads, as its checks have read them.
  std::shared_ptr<TableFiles> tables{};
};

}  // namespace armlet
