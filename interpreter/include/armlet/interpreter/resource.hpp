#pragma once
// Resources of a host, such as motors, which only one task of a program at a time may command, with
// words for messages about them.
//
// A host type with HostType::resource is a type of such resources. Two branches of one `parallel`
// that begin with commands to the same resource are refused before the run (E0501). At run time a
// command begins with `require_free`, or the host has a rule of its own.

#include <string>
#include <string_view>

#include "armlet/interpreter/answer.hpp"

namespace armlet {

// Parts of sentences, here for a resource of the type "motor".
struct ResourceWords {
  std::string_view plural;      // "motors"
  std::string_view act;         // "run": which one should run? A condition cannot wait or run
  std::string_view acts;        // "the runs": put the runs inside with (motor: m) { ... }
  std::string_view act_on_one;  // "run a motor": an imported file may not run a motor by itself
  std::string_view busy;        // "is running already": `m` is running already
  std::string_view still;       // "still running": of another task, with its line
  std::string_view begun;       // "the motor had started": what a failure came after
  std::string_view not_begun;   // "nothing has run"
  // The name of a resource with its type: "the left motor".
  std::string (*called)(std::string_view name) = nullptr;
  // For hosts with `path` blocks: the messages for a statement that is not a motion, and for
  // motions of two resources.
  struct Refusal {
    std::string_view message;
    std::string_view why;
    std::string_view fix;
  };
  Refusal not_in_path{};
  Refusal two_in_path{};
};

// Fails with R0617 if another task waits for the end of a command to this resource
// (Waiting::resource).
Answer<void> require_free(Vm& vm, const Resource& resource);

}  // namespace armlet
