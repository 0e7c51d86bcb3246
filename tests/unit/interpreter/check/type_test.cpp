#include "armlet/interpreter/type.hpp"

#include <doctest/doctest.h>

#include "armlet/interpreter/object.hpp"

namespace armlet {
namespace {

HostType type_named(std::string_view name) {
  HostType type;
  type.name = name;
  return type;
}

}  // namespace

TEST_CASE("equal types are one object") {
  TypePool types;
  CHECK(types.quantity(dims::kLength) == types.quantity(dims::kLength));
  CHECK(types.quantity(dims::kNone) == types.real());
  CHECK(types.list(types.real()) == types.list(types.real()));
  CHECK(types.list(types.real()) != types.list(types.integer()));
  CHECK(types.function({types.real()}, types.integer()) ==
        types.function({types.real()}, types.integer()));
  CHECK(types.function({types.real()}, types.integer()) !=
        types.function({types.integer()}, types.integer()));
  const HostType pose = type_named("posJ");
  CHECK(types.host(&pose) == types.host(&pose));
}

TEST_CASE("types stay where they are while others are made") {
  TypePool types;
  const Type* first = types.list(types.text());
  const Type* nested = first;
  for (int i = 0; i < 200; ++i) nested = types.list(nested);
  CHECK(types.list(types.text()) == first);
  CHECK(type_name(first) == "string[]");
}

TEST_CASE("records and enums are compared by identity") {
  TypePool types;
  CHECK(types.new_record("Pallet") != types.new_record("Pallet"));
  CHECK(types.new_enum("State", {"Idle"}) != types.new_enum("State", {"Idle"}));
}

TEST_CASE("fields and values are found by name") {
  TypePool types;
  const Type* record = types.new_record("Pallet");
  record->record->fields = {{"corner", types.real()}, {"rows", types.integer(), true}};
  CHECK(record->record->index_of("rows") == 1);
  CHECK(record->record->index_of("cols") == -1);
  const Type* state = types.new_enum("State", {"Idle", "Done"});
  CHECK(state->enumeration->index_of("Done") == 1);
  CHECK(state->enumeration->index_of("done") == -1);
}

TEST_CASE("tables with the same columns are one type; lists of numbers become a matrix") {
  TypePool types;
  const Type* time = types.quantity(dims::kTime);
  const Type* rates = types.list(types.real());
  const Type* table = types.table({{"t", time}, {"v", rates}, {"name", types.text()}});
  CHECK(table->is_table());
  CHECK_FALSE(table->record->row->is_table());
  CHECK(table->record->row->record->table == table);
  CHECK(type_phrase(table) == "a table");
  CHECK(table->record->fields[0].type == types.list(time));
  CHECK(table->record->fields[1].type == types.matrix());
  CHECK(table->record->fields[2].type == types.list(types.text()));
  CHECK(table->record->row->record->fields[1].type == rates);
  CHECK(types.table({{"t", time}, {"v", rates}, {"name", types.text()}}) == table);
  CHECK(types.table({{"t", time}, {"w", rates}, {"name", types.text()}}) != table);
  CHECK(types.table({{"t", time}, {"v", rates}}) != table);
}

TEST_CASE("library records are found by name") {
  TypePool types;
  const Type* move = types.new_record("Move");
  types.register_library_record(move);
  CHECK(types.library_record("Move") == move);
  CHECK(types.library_record("Wrench") == nullptr);
}

TEST_CASE("types are named as programs write them") {
  TypePool types;
  const HostType pose = type_named("posJ");
  CHECK(type_name(types.real()) == "double");
  CHECK(type_name(types.list(types.list(types.real()))) == "double[][]");
  CHECK(type_name(types.quantity(dims::kSpeed)) == "speed");
  CHECK(type_name(types.host(&pose)) == "posJ");
  const Type* function = types.function({types.real(), types.text()}, types.real());
  CHECK(type_name(function) == "fn(double, string) -> double");
  CHECK(type_name(types.list(function)) == "(fn(double, string) -> double)[]");
  CHECK(type_name(types.function({}, types.void_type())) == "fn()");
  CHECK(type_name(types.new_enum("State", {})) == "State");
}

TEST_CASE("phrases have the right article") {
  TypePool types;
  CHECK(type_phrase(types.integer()) == "an int");
  CHECK(type_phrase(types.list(types.real())) == "a double[]");
  CHECK(type_phrase(types.quantity(dims::kAngle)) == "an angle");
  CHECK(type_phrase(types.quantity(dims::kLength)) == "a length");
  CHECK(type_phrase(types.void_type()) == "no value");
  CHECK(article("object") == "an");
  CHECK(article("robot") == "a");
  CHECK(article("") == "a");
}

TEST_CASE("numbers and truth values are bits, everything with parts is a reference") {
  TypePool types;
  const HostType pose = type_named("posJ");
  for (const Type* bits : {types.boolean(), types.integer(), types.real(),
                           types.quantity(dims::kTime), types.new_enum("State", {})}) {
    CHECK_FALSE(bits->is_reference());
  }
  for (const Type* reference :
       {types.text(), types.matrix(), types.list(types.integer()), types.new_record("R"),
        types.host(&pose), types.function({}, types.real())}) {
    CHECK(reference->is_reference());
  }
}

}  // namespace armlet
