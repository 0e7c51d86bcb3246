#pragma once
// What a native function says when it fails.

#include <memory>
#include <optional>
#include <string>

#include "armlet/interpreter/messages/message_code.hpp"

namespace armlet {

struct HostType;
class Vm;

// A resource of the host (resource.hpp), as programs call it.
struct Resource {
  const HostType* type = nullptr;  // null: none is concerned
  std::string name{};
};

// A call of a native function that is over, for what goes wrong later on its account. It is valid
// as long as the program.
class CallPlace {
 public:
  CallPlace() = default;
  explicit CallPlace(const void* code) : code_(code) {}
  [[nodiscard]] const void* code() const { return code_; }

 private:
  const void* code_ = nullptr;  // null: none
};
// The call that is running.
[[nodiscard]] CallPlace place_of_call(Vm& vm);
// Whether `until` guards it.
[[nodiscard]] bool is_guarded(Vm& vm);

// What a native function that takes a failure back (taken_failure.hpp) can go on with.
struct FailureDetail {
  FailureDetail() = default;
  FailureDetail(const FailureDetail&) = default;
  FailureDetail& operator=(const FailureDetail&) = default;
  virtual ~FailureDetail() = default;
};

// Why a native function failed. The position is added by the interpreter.
struct Failure {
  Headline headline;  // {"R0606", {index, range}}; its code gives the kind
  std::string kind;   // replaces the code's kind if not empty
  int mark_parameter =
      -1;                 // which argument to mark; -1: the call; kMarkCallee: the function's name
  int mark_element = -1;  // element of a list argument (or of the position made from it) at fault
  std::string element_label;  // label for the place where that element was written
  std::string label;
  std::string why;
  // May contain "line {line}", where the marked element was written, and {arg}, the text of the
  // marked argument.
  std::string fix;
  Resource resource;          // that was commanded
  std::optional<bool> moved;  // whether it had begun to do so
  CallPlace place;            // marks belong to this call instead of the running one
  std::shared_ptr<const FailureDetail> detail;  // null: none; shared with errors that were caught
};
inline constexpr int kMarkCallee = -2;

}  // namespace armlet
