#pragma once
// What one task of a program at a time may command, such as a motor, and the words of its host.
//
// A type of the host whose HostType::resource is set names such resources. Two branches of one
// `parallel` that begin by commanding the same one are refused before the run (E0501). While the
// program runs, a command begins with `require_free`, or the host has a rule of its own.

#include <string>
#include <string_view>

#include "armlet/interpreter/answer.hpp"

namespace armlet {

// Parts of sentences, for a resource whose type is called "motor".
struct ResourceWords {
  std::string_view plural;      // "motors"
  std::string_view act;         // "run": which one should run? A condition cannot wait or run
  std::string_view acts;        // "the runs": put the runs inside with (motor: m) { ... }
  std::string_view act_on_one;  // "run a motor": an imported file may not run a motor by itself
  std::string_view busy;        // "is running already": `m` is running already
  std::string_view still;       // "still running": of another task, with its line
  std::string_view begun;       // "the motor had started": what a failure came after
  std::string_view not_begun;   // "nothing has run"
  // "the left motor", for the name of one.
  std::string (*called)(std::string_view name) = nullptr;
  // Of a host with `path` blocks: what is said where a part is none of its motions, and where the
  // motions are those of two resources.
  struct Refusal {
    std::string_view message;
    std::string_view why;
    std::string_view fix;
  };
  Refusal not_in_path{};
  Refusal two_in_path{};
};

// Fails with R0617 while another task waits for a command of this resource to end
// (Waiting::resource).
Answer<void> require_free(Vm& vm, const Resource& resource);

}  // namespace armlet
