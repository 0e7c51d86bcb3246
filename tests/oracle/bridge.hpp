#pragma once
// Calls the native functions of the library for the oracle: they are not part of what is compared.

#include <memory>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "program/program.hpp"
#include "value.hpp"
#include "vm/state/task.hpp"

namespace armlet::oracle {

class Bridge {
 public:
  Bridge(std::shared_ptr<const Program> program, void* host);
  ~Bridge();

  // Throws a Failure if the function fails.
  [[nodiscard]] Value call(const lang::hir::CallNativeExpr& call,
                           const std::vector<Value>& arguments);

 private:
  [[nodiscard]] Signal run(const NativeFunction& function, Slot* window);
  [[nodiscard]] Slot to_slot(const Value& value, const Type& type);
  [[nodiscard]] Value from_slot(Slot slot, const Type& type) const;
  // Makes the call the running instruction, so that messages find their marks.
  void pretend_to_run(const lang::hir::CallNativeExpr& call);

  Vm vm_;
  lang::FunctionCode code_;
  lang::Callee callee_{};  // the instruction that seems to run
};

}  // namespace armlet::oracle
