// Entries of a session: each runs in the cell and with the variables that the entries before it
// have left.

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "session/run.hpp"

namespace armlet {

bool Session::submit(std::string text, std::string name) {
  require_rest("the session takes the next one");
  const std::vector<Entry>& known = run_->entries;
  if (!known.empty() && known.front().logged.kind == EntryKind::kProgram)
    run_ = std::make_unique<Run>();
  return compile_entry(
      {.kind = EntryKind::kEntry, .name = std::move(name), .text = std::move(text)});
}

void Session::begin_call(std::string_view name, const std::vector<Value>& arguments) {
  require_rest("a function can be called");
  require_run("call a function");
  const OneSlice one_slice(*this);
  begin_new({.logged = {.kind = EntryKind::kCall,
                        .name = std::string(name),
                        .text = {},
                        .arguments = arguments},
             .program = nullptr});
}

// The program of the last entry that has run; a call has no program of its own.
std::shared_ptr<const Program> Session::newest_program() const {
  for (std::size_t i = run_->done; i > 0; --i) {
    const Entry& entry = run_->entries[i - 1];
    if (entry.logged.kind == EntryKind::kEntry) return entry.program;
  }
  return nullptr;
}

std::optional<EntryValue> Session::shown() const {
  return run_->vm != nullptr ? run_->vm->shown() : std::nullopt;
}

std::span<const Entry> Session::entries() const { return {run_->entries.data(), run_->done}; }

std::size_t Session::to_come() const { return run_->entries.size() - run_->done; }

std::size_t Session::undo(std::size_t count) {
  require_rest("what is before it can be undone");
  count = std::min(count, run_->done);
  return go_to_rest(run_->done - count) ? count : 0;
}

std::size_t Session::redo(std::size_t count) {
  require_rest("what was undone can be done again");
  count = std::min(count, to_come());
  return go_to_rest(run_->done + count) ? count : 0;
}

}  // namespace armlet
