#pragma once
// Failures of native functions.

#include <memory>
#include <optional>
#include <string>

#include "armlet/interpreter/call_part.hpp"
#include "armlet/interpreter/messages/message_code.hpp"

namespace armlet {

struct HostType;
class Vm;

// A resource of the host (resource.hpp), with its name in the program.
struct Resource {
  const HostType* type = nullptr;  // null: none
  std::string name{};
};

// A finished call of a native function, for failures that it causes later. It is valid as long as
// the program.
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
// Whether the running call is guarded by `until`.
[[nodiscard]] bool is_guarded(Vm& vm);

// Base class for data about a failure, for a native function that takes the failure back
// (taken_failure.hpp).
struct FailureDetail {
  FailureDetail() = default;
  FailureDetail(const FailureDetail&) = default;
  FailureDetail& operator=(const FailureDetail&) = default;
  virtual ~FailureDetail() = default;
};

// The failure of a native function. The interpreter adds the position.
struct Failure {
  Headline headline;  // {"R0606", {index, range}}; its code gives the kind
  std::string kind;   // replaces the kind of the code, if not empty
  CallPart mark;
  // The element of a list argument (or of the position made from it) that is wrong.
  int mark_element = -1;
  std::string element_label;  // label at the position of that element in the text
  std::string label;
  std::string why;
  // May contain "line {line}", the line of the marked element, and {arg}, the text of the marked
  // argument.
  std::string fix;
  Resource resource;          // that was commanded
  std::optional<bool> moved;  // whether its command had begun
  CallPlace place;            // the marks are in this call and not in the running one
  std::shared_ptr<const FailureDetail> detail;  // null: none; shared with errors that were caught
};

}  // namespace armlet
