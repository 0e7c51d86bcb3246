#include "armlet/interpreter/work.hpp"

#include <cstring>
#include <vector>

#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"

namespace armlet {

bool charge_steps(Vm& vm, std::uint64_t steps) {
  lang::VmState& state = vm.state();
  const auto left = [&state] { return static_cast<std::uint64_t>(state.steps.left); };
  while (steps > left()) {
    steps -= left();
    if (!lang::count_slowly(state)) return false;
    --steps;  // count_slowly counts one step itself
  }
  state.steps.left -= static_cast<std::int64_t>(steps);
  return true;
}

Scratch::Scratch(Vm& vm, std::uint64_t bytes)
    : vm_(vm), bytes_(bytes), granted_(vm.state().heap.charge(bytes)) {
  if (!granted_) lang::raise_out_of_memory(vm.state());
}

Scratch::~Scratch() {
  if (granted_) vm_.state().heap.discharge(bytes_);
}

// ---- text -----------------------------------------------------------------------------------

TextMaker::~TextMaker() {
  if (text_ != nullptr) vm_.state().heap.release(text_);
}

bool TextMaker::add(std::string_view piece) {
  constexpr std::size_t kShort = 4096;
  if (failed_) return false;
  lang::VmState& state = vm_.state();
  const auto append = [&](std::size_t begin, std::size_t end) {
    text_ = lang::append_bytes(state.heap, text_, piece.substr(begin, end - begin));
    return text_ != nullptr || lang::raise_out_of_memory(state);
  };
  if (piece.size() >= kShort) {
    failed_ = !in_blocks(vm_, piece.size(), 1, append);
    return !failed_;
  }
  work_ += piece.size() + 16;
  if (work_ >= kShort) {
    failed_ = !charge_work(vm_, work_);
    work_ = 0;
  }
  failed_ = failed_ || !append(0, piece.size());
  return !failed_;
}

Obj* TextMaker::take() {
  if (failed_) return nullptr;
  Obj* made = text_ != nullptr ? text_ : new_text(vm_, {});
  text_ = nullptr;
  return made;
}

ListMaker::~ListMaker() {
  if (list_ != nullptr) vm_.state().heap.release(list_);
}

bool ListMaker::push(Obj* object) {
  constexpr std::uint64_t kCost = 64;
  lang::VmState& state = vm_.state();
  if (object == nullptr) return false;
  if (list_ == nullptr) list_ = new_list(vm_, 0, true);
  work_ += kCost;
  bool done = list_ != nullptr && (work_ < kBlockWork || charge_work(vm_, work_));
  if (work_ >= kBlockWork) work_ = 0;
  if (done && !lang::reserve_list(state.heap, *list_, std::uint64_t{list_->size} + 1))
    done = lang::raise_out_of_memory(state);
  if (done) {
    list_->data[list_->size++].o = object;
  } else {
    state.heap.release(object);
  }
  return done;
}

Obj* ListMaker::take() {
  Obj* made = list_ != nullptr ? list_ : new_list(vm_, 0, true);
  list_ = nullptr;
  return made;
}

namespace {

// Longer patterns are searched with a table. A stop request may interrupt the making of the table.
constexpr std::size_t kLongPattern = std::size_t{1} << 16U;

// Whether the text from `from` on contains the pattern. It searches in overlapping windows, each in
// linear time (Crochemore and Perrin's algorithm in the C library).
bool find_short(Vm& vm, std::string_view text, std::string_view what, std::size_t from,
                std::size_t& at) {
  constexpr std::size_t kWindow = 4 * kLongPattern;
  at = std::string_view::npos;
  for (std::size_t begin = from; begin < text.size(); begin += kWindow) {
    const std::string_view window = text.substr(begin, kWindow + what.size() - 1);
    const void* found = memmem(window.data(), window.size(), what.data(), what.size());
    const auto seen =
        found == nullptr
            ? window.size()
            : static_cast<std::size_t>(static_cast<const char*>(found) - window.data());
    if (!charge_work(vm, seen + what.size())) return false;
    if (found == nullptr) continue;
    at = static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
    break;
  }
  return true;
}

// The algorithm of Knuth, Morris and Pratt. border[i]: the length of the longest proper prefix of
// the pattern's first i + 1 bytes that is also their suffix.
bool find_long(Vm& vm, std::string_view text, std::string_view what, std::size_t from,
               std::size_t& at) {
  const Scratch scratch(vm, what.size() * sizeof(std::uint32_t));
  if (!scratch.granted()) return false;
  std::vector<std::uint32_t> border(what.size());
  const auto grow = [&](std::uint32_t matched, char next) {
    while (matched > 0 && what[matched] != next) matched = border[matched - 1];
    return what[matched] == next ? matched + 1 : matched;
  };
  const auto make_borders = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i)
      border[i] = grow(border[i - 1], what[i]);
  };
  if (!in_blocks(vm, what.size(), 4, make_borders)) return false;
  at = std::string_view::npos;
  std::uint32_t matched = 0;
  const auto search = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = from + begin; i < from + end && at == std::string_view::npos; ++i) {
      matched = grow(matched, text[i]);
      if (matched == what.size()) at = i + 1 - what.size();
    }
    return at == std::string_view::npos;
  };
  return in_blocks(vm, text.size() - from, 4, search) || at != std::string_view::npos;
}

}  // namespace

bool find_text(Vm& vm, std::string_view text, std::string_view what, std::size_t from,
               std::size_t& at) {
  if (what.empty() || from > text.size() || what.size() > text.size() - from) {
    at = what.empty() && from <= text.size() ? from : std::string_view::npos;
    return true;
  }
  return what.size() < kLongPattern ? find_short(vm, text, what, from, at)
                                    : find_long(vm, text, what, from, at);
}

}  // namespace armlet
