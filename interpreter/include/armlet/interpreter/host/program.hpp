#pragma once
// A compiled program, which an Engine makes from a text and a Vm runs.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet {

// A compiled program. All virtual machines and sessions that run it share it.
class Program {
 public:
  struct Code;  // internal
  explicit Program(std::unique_ptr<Code> compiled);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] const SourceSet& sources() const;
  [[nodiscard]] std::vector<std::string> test_names() const;
  // Whether the text uses a library function of this name.
  [[nodiscard]] bool mentions(std::string_view function) const;
  // Whether the program uses a name of the world that it does not declare; and the names of its
  // declarations of a type, in their order.
  [[nodiscard]] bool uses_world() const;
  [[nodiscard]] std::vector<std::string> declared_names(std::string_view type) const;
  // Whether it is an entry of a session; and the entry before it, null for the first one.
  [[nodiscard]] bool is_entry() const;
  [[nodiscard]] const std::shared_ptr<const Program>& after() const;
  [[nodiscard]] std::string disassemble() const;
  // The type of a record of the library, or of `name<S>{...}` in signatures with `of` for S; null
  // if there is none.
  [[nodiscard]] const Type* library_record(std::string_view name, const Type* of = nullptr) const;
  [[nodiscard]] const Code& compiled() const { return *compiled_; }

 private:
  std::unique_ptr<Code> compiled_;
};

}  // namespace armlet
