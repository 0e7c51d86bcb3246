#include "vm/heap/format_value.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "vm/heap/heap.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

std::string formatted(double value, const Type* type, int digits, char style, const char* unit = "",
                      double factor = 1.0) {
  const TextStyle how{.digits = static_cast<std::int8_t>(digits), .notation = style};
  return format_value(slot_of(value), Format{type, how, unit, factor});
}

}  // namespace

TEST_CASE("a double has the fewest digits that read back, and always a point or an exponent") {
  CHECK(number_text(2.0) == "2.0");
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(1e-7) == "1e-07");
  CHECK(number_text(1.5e-7) == "1.5e-07");
  CHECK(number_text(0.0001) == "0.0001");
  CHECK(number_text(0.00001) == "1e-05");
  CHECK(number_text(-12.25) == "-12.25");
  CHECK(number_text(123456789.0) == "123456789.0");
  CHECK(number_text(1e14) == "100000000000000.0");
  CHECK(number_text(1e15) == "1e+15");
  CHECK(number_text(1e300) == "1e+300");
}

TEST_CASE("at most 15 digits are written") {
  CHECK(number_text(0.1 + 0.2) == "0.3");
  CHECK(number_text(1.0 / 3.0) == "0.333333333333333");
  CHECK(number_text(2.0 / 3.0) == "0.666666666666667");
  CHECK(number_text(0.99999999999999999) == "1.0");
  CHECK(number_text(9.9999999999999982) == "10.0");
}

TEST_CASE("zero has no sign, and what is not finite has a word") {
  CHECK(number_text(-0.0) == "0.0");
  CHECK(number_text(std::nan("")) == "nan");
  CHECK(number_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(number_text(-std::numeric_limits<double>::infinity()) == "-inf");
}

TEST_CASE("quantities choose their unit by size") {
  CHECK(quantity_text(0.02, dims::kLength) == "20 mm");
  CHECK(quantity_text(1.5, dims::kLength) == "1.5 m");
  CHECK(quantity_text(std::acos(-1.0) / 2, dims::kAngle) == "90 deg");
  CHECK(quantity_text(0.3, dims::kMass) == "300 g");
  CHECK(quantity_text(2.0, dims::kTime) == "2 s");
  CHECK(quantity_text(0.1, dims::kSpeed) == "0.1 m/s");
}

TEST_CASE("formats fix the digits, the style and the unit") {
  TypePool types;
  const Type* real = types.real();
  const Type* length = types.quantity(dims::kLength);
  CHECK(formatted(3.14159, real, 2, 'f') == "3.14");
  CHECK(formatted(3.14159, real, 2, 0) == "3.14");
  CHECK(formatted(31415.9, real, 2, 'e') == "3.14e+04");
  CHECK(formatted(0.5, real, 4, 'g') == "0.5");
  CHECK(formatted(0.0203, length, 1, 'f', "mm", 1e-3) == "20.3 mm");
  CHECK(formatted(0.0203, length, -1, 0, "mm", 1e-3) == "20.3 mm");
  CHECK(formatted(0.0203, length, 0, 'f') == "20 mm");
  CHECK(formatted(-0.001, real, 2, 'f') == "0.00");
  CHECK(formatted(std::nan(""), real, 2, 'f') == "nan");
}

TEST_CASE("lists, records and choices are written as they would be in a program") {
  TypePool types;
  Heap heap(1U << 20U);
  ListObj* numbers = heap.new_list(2, false);
  numbers->data[0].d = 1.0;
  numbers->data[1].d = 2.5;
  CHECK(value_text(slot_of(static_cast<Obj*>(numbers)), *types.list(types.real())) == "[1.0, 2.5]");

  ListObj* texts = heap.new_list(1, true);
  texts->data[0].o = heap.new_text("say \"hi\"");
  CHECK(value_text(slot_of(static_cast<Obj*>(texts)), *types.list(types.text())) ==
        "[\"say \\\"hi\\\"\"]");
  CHECK(value_text(texts->data[0], *types.text()) == "say \"hi\"");

  const Type* pallet = types.new_record("Pallet");
  pallet->record->fields = {{"width", types.quantity(dims::kLength), false},
                            {"rows", types.integer(), false}};
  const RecordLayout layout{pallet, 2, {}};
  RecordObj* record = heap.new_record(layout);
  record->fields()[0].d = 0.08;
  record->fields()[1].i = 2;
  CHECK(value_text(slot_of(static_cast<Obj*>(record)), *pallet) == "Pallet(width: 80 mm, rows: 2)");

  const Type* state = types.new_enum("State", {"Idle", "Done"});
  CHECK(value_text(slot_of(std::int64_t{1}), *state) == "State.Done");
  CHECK(value_text(slot_of(true), *types.boolean()) == "true");
  CHECK(value_text(slot_of(std::int64_t{-3}), *types.integer()) == "-3");

  MatrixObj* matrix = heap.new_matrix(2, 2);
  for (int i = 0; i < 4; ++i) matrix->data()[i] = i;
  CHECK(value_text(slot_of(static_cast<Obj*>(matrix)), *types.matrix()) == "[0.0, 1.0; 2.0, 3.0]");
  for (Obj* object : {static_cast<Obj*>(numbers), static_cast<Obj*>(texts),
                      static_cast<Obj*>(record), static_cast<Obj*>(matrix)}) {
    heap.release(object);
  }
}

TEST_CASE("writing stops soon after the limit") {
  TypePool types;
  Heap heap(1U << 24U);
  ListObj* list = heap.new_list(100'000, false);
  CHECK(value_text(slot_of(static_cast<Obj*>(list)), *types.list(types.real()), 100).size() < 120);
  heap.release(list);
}

TEST_CASE("values nested without end are cut") {
  TypePool types;
  Heap heap(1U << 24U);
  const Type* node = types.new_record("Node");
  node->record->fields = {{"next", types.list(node), false}};
  const std::vector<std::uint16_t> references{0};
  const RecordLayout layout{node, 1, references};
  Obj* top = nullptr;
  for (int i = 0; i < 10'000; ++i) {
    RecordObj* record = heap.new_record(layout);
    ListObj* list = heap.new_list(top == nullptr ? 0 : 1, true);
    if (top != nullptr) list->data[0].o = top;
    record->fields()[0].o = list;
    top = record;
  }
  CHECK(value_text(slot_of(top), *node).find("...") != std::string::npos);
  heap.release(top);
  heap.drain();
  CHECK(heap.used() == 0);
}
