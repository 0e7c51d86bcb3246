#include "hir/checked_program.hpp"

#include "hir/kept.hpp"

namespace armlet::lang {

CheckedProgram::CheckedProgram(const CheckedProgram* before, bool is_entry)
    : sources(std::make_shared<SourceSet>(before != nullptr ? before->sources : nullptr)),
      arena(std::make_unique<Arena>()),
      types(before != nullptr ? std::make_shared<TypePool>(before->types.get())
                              : std::make_shared<TypePool>()) {
  entry.is_one = is_entry || before != nullptr;
  if (before != nullptr) entry.before = before->entry.kept.get();
}
CheckedProgram::CheckedProgram(CheckedProgram&&) noexcept = default;
CheckedProgram& CheckedProgram::operator=(CheckedProgram&&) noexcept = default;
CheckedProgram::~CheckedProgram() = default;

}  // namespace armlet::lang
