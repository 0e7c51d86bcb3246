#include "armlet/interpreter/host/value.hpp"

#include "host_support.hpp"
#include "refusal_of.hpp"

using namespace armlet;

TEST_CASE("a value knows what it is") {
  CHECK(Value().kind() == "nothing");
  CHECK(Value(true).kind() == "a bool");
  CHECK(Value(3).kind() == "an int");
  CHECK(Value(3.0).kind() == "a double");
  CHECK(Value(3, "mm").kind() == "a length");
  CHECK(Value("x").kind() == "a string");
  CHECK(Value{1, 2}.kind() == "a list");
  CHECK(Value(Value::Enum{"State", "Idle"}).kind() == "a State");
}

TEST_CASE("a number is asked for in a unit of its dimension") {
  CHECK(Value(0.2, "m/s").in("mm/s") == 200.0);
  CHECK(Value(90, "deg").get<Value::Number>().si == doctest::Approx(1.5707963267948966));
  CHECK(Value(3).in() == 3.0);
  CHECK(Value(2.5).in() == 2.5);
  CHECK(refusal_of([] { static_cast<void>(Value(1, "mm").in("s")); }) ==
        "This value is a length, not a time.");
  CHECK(refusal_of([] { static_cast<void>(Value(1, "mm").in()); }) ==
        "This value is a length, not a number without a unit.");
  CHECK(refusal_of([] { static_cast<void>(Value("x").in("mm")); }) ==
        "This value is a string, not a length.");
  CHECK(refusal_of([] {
          static_cast<void>(Value(1, "miles"));
        }).starts_with("There is no unit `miles`"));
}

TEST_CASE("equal values have equal content, whatever their kind") {
  const Value::Record stop{"Stop", {{"at", Value(1, "m")}}};
  CHECK(Value(stop) == Value(stop));
  CHECK(Value(1) != Value(1.0));
  CHECK(Value(1.0) != Value(1.0, "m"));
  CHECK(Value(stop)["at"] == Value(1000, "mm"));
  CHECK(refusal_of([&] { static_cast<void>(Value(stop)["name"]); }) ==
        "This value is a Stop, not one with a field `name`.");
}

TEST_CASE("a value of any depth is destroyed") {
  Value list;
  Value record;
  Value map;
  for (int i = 0; i < 300000; ++i) {  // without initializer lists, whose elements are copied
    Value::List items;
    items.push_back(std::move(list));
    items.emplace_back(i);
    list = Value(std::move(items));
    Value::Record node{"Node", {}};
    node.fields.emplace_back("next", std::move(record));
    record = Value(std::move(node));
    Value::Map entries;
    entries.emplace_back(Value(i), std::move(map));
    map = Value(std::move(entries));
  }
  CHECK(list.kind() == "a list");
  CHECK(record.kind() == "a Node");
  CHECK(map.kind() == "a map");
}
