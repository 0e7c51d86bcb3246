#include "vm/host/language_functions.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "armlet/interpreter/host/vm.hpp"
#include "armlet/interpreter/work.hpp"
#include "vm/host/list_natives.hpp"
#include "vm/tasks/recordings.hpp"

namespace armlet::lang {
namespace {

Signal print_text(Vm& vm, Slot* args) {
  return vm.print(text_value(args[0])) ? give_nothing() : Signal::kFail;
}

constexpr NativeFunction kPrint = {
    .name = "print",
    .signature = "(text: string)",
    .help = "Writes its values, separated by spaces, and ends the line.",
    .example = "print(1, \"two\")",
    .thunk = &print_text};

Signal last_element(Vm& vm, Slot* args) {
  const auto* list = static_cast<const ListObj*>(args[0].o);
  if (list->size == 0) {
    Failure failure;
    failure.headline = Headline::own("R0606", "an empty list has no last value");
    failure.mark = CallPart::first();
    return fail(vm, std::move(failure));
  }
  const Slot last = list->data[list->size - 1];
  if (list->holds_references() && last.o == nullptr) {
    Failure failure;
    failure.headline =
        Headline::own("R0623", "the last element of this list is read before it has a value");
    failure.mark = CallPart::first();
    return fail(vm, std::move(failure));
  }
  if (list->holds_references()) retain(last.o);
  args[0] = last;
  return Signal::kDone;
}

// All elements share one object until one of them is changed.
Signal fill(Vm& vm, Slot* args) {
  const std::int64_t size = args[0].i;
  Obj* const value = args[1].o;
  if (size < 0) {
    Failure failure;
    failure.headline = Headline::own(
        "R0613", "the sizes do not fit: a list cannot have " + std::to_string(size) + " values");
    return fail(vm, std::move(failure));
  }
  if (!charge_work(vm, static_cast<std::uint64_t>(size))) return Signal::kFail;
  constexpr std::int64_t kMost = 0x7FFF'FFFF;
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(std::min(size, kMost)), true);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i) {
    retain(value);
    list->data[i].o = value;
  }
  args[0].o = list;
  return Signal::kDone;
}

constexpr NativeFunction kLast = {.name = "last",
                                  .signature = "(xs: T[]) -> T",
                                  .help = "The last value of a list.",
                                  .example = "[1, 2].last",
                                  .thunk = &last_element};

constexpr NativeFunction kFilled = {.name = "new",
                                    .signature = "(size: int, value: T) -> T[]",
                                    .help = "A list of equal structs.",
                                    .example = "struct Bin { n: int = 0 }; print(new Bin[2])",
                                    .thunk = &fill};

}  // namespace

const LanguageFunctions kLanguageFunctions = {
    .print = &kPrint,
    .filled = &kFilled,
    .last = &kLast,
    .start_recording = &kStartRecording,
    .end_recording = &kEndRecording,
    .table_column = &kTableColumn,
    .table_rows = &kTableRows,
    .table_length = &kTableLength,
    .common_length = &kCommonLength,
    .sort_by_int = &kSortByInt,
    .sort_by_real = &kSortByReal,
    .sort_by_text = &kSortByText,
};

}  // namespace armlet::lang
