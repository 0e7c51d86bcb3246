#pragma once
// One task: its slots, its frames, and what it waits for.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "armlet/interpreter/native.hpp"
#include "compile/program.hpp"

namespace armlet::lang {

// A function as the loop needs it: small, and all in one array.
struct Callee {
  const Instr* code;
  const FunctionCode* function;  // null: the host
  std::uint16_t registers;
  std::uint16_t references_begin;  // the first reference register
  std::uint16_t references;        // how many there are
  std::uint16_t reserved;
};

struct Frame {
  const Instr* pc;  // the next instruction, while something else runs
  Slot* base;       // register 0
  const Callee* callee;
  ClosureObj* closure;  // the running function value; not set for functions that are called by name

  [[nodiscard]] bool is_host() const { return callee->function == nullptr; }
  // The instruction that is being executed.
  [[nodiscard]] std::uint32_t at() const {
    return static_cast<std::uint32_t>(pc - callee->code) - 1;
  }
};

// Address space whose pages get memory when they are first touched, so that addresses in it never
// change.
class AddressSpace {
 public:
  // Throws std::bad_alloc if the system has no addresses left.
  explicit AddressSpace(std::size_t bytes);
  ~AddressSpace();
  AddressSpace(const AddressSpace&) = delete;
  AddressSpace& operator=(const AddressSpace&) = delete;

  [[nodiscard]] void* begin() const { return begin_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void* begin_;
  std::size_t bytes_;
};

struct Fault;

// A task waits while `waiting` is set.
struct Task {
  // call_depth  calls that may be nested.
  // slots       of all frames together, besides the one on top.
  Task(std::uint32_t call_depth, std::size_t slots);

  AddressSpace slot_space;
  AddressSpace frame_space;
  Slot* slots_end;  // a frame that starts before it fits
  Frame* frames;    // frames[0] belongs to the host
  Frame* frames_end;
  Frame* top;

  std::unique_ptr<Waiting> waiting;
  Slot* result = nullptr;                 // where the waiting call leaves its result
  Obj* condition = nullptr;               // armed: when it comes true, `waiting` is stopped; owned
  std::shared_ptr<Fault> interrupted;     // raised instead of going on when the wait is over
  std::shared_ptr<const void> host_data;  // see Vm::task_data
};

}  // namespace armlet::lang
