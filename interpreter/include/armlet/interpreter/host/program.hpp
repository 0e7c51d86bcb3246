#pragma once
// A program that can run: what an Engine makes of a text, and a Vm runs.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet {

// A checked program. Shared by all who run it.
class Program {
 public:
  struct Code;  // the interpreter's own
  explicit Program(std::unique_ptr<Code> compiled);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] const SourceSet& sources() const;
  [[nodiscard]] std::vector<std::string> test_names() const;
  // Whether the text mentions a library function of this name.
  [[nodiscard]] bool mentions(std::string_view function) const;
  // Whether a name of the world is used that the program does not declare itself, and the names
  // that its declarations of a type have, in their order.
  [[nodiscard]] bool uses_world() const;
  [[nodiscard]] std::vector<std::string> declared_names(std::string_view type) const;
  // Whether it is an entry of a session, and the entry before it; null: it is the first.
  [[nodiscard]] bool is_entry() const;
  [[nodiscard]] const std::shared_ptr<const Program>& after() const;
  [[nodiscard]] std::string disassemble() const;
  // A record of the library, or of `name<S>{...}` in signatures with `of` for S; null if none.
  [[nodiscard]] const Type* library_record(std::string_view name, const Type* of = nullptr) const;
  [[nodiscard]] const Code& compiled() const { return *compiled_; }

 private:
  std::unique_ptr<Code> compiled_;
};

}  // namespace armlet
