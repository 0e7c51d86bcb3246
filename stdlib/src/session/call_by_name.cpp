#include "session/call_by_name.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/value.hpp"

namespace armlet {
namespace {

// The function, and whether it returns a value.
struct Found {
  ReadyFunction function;
  bool gives;
};

Found find(Vm& vm, std::string_view name, std::size_t parameters) {
  if (parameters > ReadyFunction::kMostParameters) {
    throw ArgumentError(fmt::format("`{}` is called with {} values; hosts pass at most {}.", name,
                                    parameters, ReadyFunction::kMostParameters));
  }
  const std::vector<ValueKind> takes(parameters);
  const Result<ReadyFunction> action =
      ReadyFunction::find(vm, name, takes, {ValueKind::Form::kNothing});
  if (action.ok()) return {*action, false};
  return {ReadyFunction::find(vm, name, takes, {}).value(), true};
}

}  // namespace

ReadyFunction find_function(Vm& vm, std::string_view name, std::size_t parameters) {
  return find(vm, name, parameters).function;
}

Result<Value> call_function(Vm& vm, std::string_view name, const std::vector<Value>& arguments,
                            const std::function<void()>& on_call) {
  const auto [function, gives] = find(vm, name, arguments.size());
  ReadyFunction::Call call(function, ReadyFunction::Counts::kWithRun);
  std::vector<Slot> slots(arguments.size());
  Slot result{.i = 0};
  for (std::size_t i = 0; i < arguments.size(); ++i)
    static_cast<void>(call.pass(i, arguments[i], slots[i]));
  on_call();
  if (!call.run(slots, result).done) return Error{"failed", vm.error()->message};
  return gives ? call.take<Value>(result) : Value();
}

}  // namespace armlet
