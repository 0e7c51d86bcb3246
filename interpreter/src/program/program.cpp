#include "program/program.hpp"

#include <algorithm>
#include <utility>

namespace armlet {

Program::Program(std::unique_ptr<Code> compiled) : compiled_(std::move(compiled)) {}
Program::~Program() = default;

const SourceSet& Program::sources() const { return *compiled_->sources; }

std::vector<std::string> Program::test_names() const {
  std::vector<std::string> names;
  for (const lang::hir::Test& test : compiled_->module.tests) names.emplace_back(test.name);
  return names;
}

bool Program::mentions(std::string_view function) const {
  return std::ranges::binary_search(compiled_->names.functions, function);
}

bool Program::uses_world() const { return compiled_->names.of_world; }

std::vector<std::string> Program::declared_names(std::string_view type) const {
  const auto found = compiled_->names.declared.find(type);
  return found == compiled_->names.declared.end() ? std::vector<std::string>() : found->second;
}

bool Program::is_entry() const { return compiled_->entry.is_one; }
const std::shared_ptr<const Program>& Program::after() const { return compiled_->after; }

std::string Program::disassemble() const { return lang::disassemble(*compiled_); }
const Type* Program::library_record(std::string_view name, const Type* of) const {
  if (of == nullptr) return compiled_->types->library_record(name);
  return compiled_->types->made_record(std::string(name) + '<' + type_name(of) + '>', of);
}

namespace lang {

CheckedProgram new_program(const CompileOptions& options) {
  return CheckedProgram(options.after != nullptr ? &options.after->compiled() : nullptr,
                        options.is_entry);
}

// The programs of earlier entries are destroyed one after the other. Otherwise each destructor
// would call the next one, as deep as the session is long.
CompiledProgram::~CompiledProgram() {
  std::shared_ptr<const Program> last = std::move(after);
  while (last != nullptr && last.use_count() == 1)
    last = std::exchange(last->compiled().after, nullptr);
}

}  // namespace lang

}  // namespace armlet
