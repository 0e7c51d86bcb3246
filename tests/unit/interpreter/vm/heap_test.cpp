#include "vm/heap/heap.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace armlet;
using namespace armlet::lang;

namespace {

constexpr std::uint64_t kPlenty = 1U << 26U;

// A list that owns `item`.
ListObj* list_of(Heap& heap, Obj* item) {
  ListObj* list = heap.new_list(1, true);
  list->data[0].o = item;
  return list;
}

}  // namespace

TEST_CASE("every byte is counted and given back") {
  Heap heap(kPlenty);
  TextObj* text = heap.new_text("0123456789");
  CHECK(heap.used() == 48);  // 24 of the header and 10, in units of 16
  ListObj* list = heap.new_list(100, false);
  CHECK(heap.used() == 48 + 32 + 800);
  heap.release(text);
  heap.release(list);
  CHECK(heap.used() == 0);
}

TEST_CASE("a heap that rests without objects keeps no memory, and works on") {
  Heap heap(kPlenty);
  TextObj* text = heap.new_text("left");
  ListObj* list = heap.new_list(3, true);
  heap.rest();
  CHECK(heap.reserved() > 0);
  CHECK(text->view() == "left");
  heap.release(text);
  heap.release(list);
  heap.rest();
  CHECK(heap.reserved() == 0);
  text = heap.new_text("again");
  REQUIRE(text != nullptr);
  CHECK(text->view() == "again");
  heap.release(text);
}

TEST_CASE("the limit is exact") {
  Heap heap(96);
  TextObj* first = heap.new_text("0123456789");
  TextObj* second = heap.new_text("0123456789");
  CHECK(heap.new_text("") == nullptr);
  heap.release(first);
  TextObj* third = heap.new_text("0123456789");
  CHECK(third != nullptr);
  heap.release(second);
  heap.release(third);
  CHECK(heap.used() == 0);
}

TEST_CASE("blocks that are free but of the wrong size do not let a heap outgrow its limit") {
  constexpr std::uint64_t kLimit = 8'000'000;
  Heap heap(kLimit);
  std::vector<Obj*> texts;
  for (const std::size_t size : {std::size_t{8}, std::size_t{40}, std::size_t{100'000}}) {
    const std::string text(size, 'x');
    for (Obj* object = heap.new_text(text); object != nullptr; object = heap.new_text(text)) {
      texts.push_back(object);
    }
    CHECK(heap.reserved() <= kLimit * 101 / 100 + 64 * 1024);
    if (size == 8) CHECK(heap.used() >= kLimit * 99 / 100);
    for (Obj* object : texts) heap.release(object);
    texts.clear();
    CHECK(heap.used() == 0);
  }
}

TEST_CASE("a list too long for the heap is refused, and leaves nothing behind") {
  Heap heap(1000);
  CHECK(heap.new_list(1000, false) == nullptr);
  CHECK(heap.new_list(1ULL << 40U, false) == nullptr);
  CHECK(heap.used() == 0);
}

TEST_CASE("a chain of a million lists is destroyed without recursion") {
  Heap heap(kPlenty * 4);
  Obj* chain = heap.new_list(0, true);
  for (int i = 0; i < 1'000'000; ++i) chain = list_of(heap, chain);
  heap.release(chain);
  CHECK(heap.used() > 0);  // only some of it at once
  heap.drain();
  CHECK(heap.used() == 0);
}

TEST_CASE("an object with two owners survives the first") {
  Heap heap(kPlenty);
  TextObj* text = heap.new_text("shared");
  retain_object(text);
  ListObj* list = list_of(heap, text);
  heap.release(list);
  CHECK(text->refs == 1);
  CHECK(text->view() == "shared");
  heap.release(text);
  CHECK(heap.used() == 0);
}

TEST_CASE("what is dead is freed bit by bit, and when memory is needed") {
  Heap heap(24'000'000);
  // A list of many, and a chain.
  ListObj* many = heap.new_list(200'000, true);
  for (std::uint32_t i = 0; i < many->size; ++i) many->data[i].o = heap.new_text("item");
  Obj* chain = heap.new_list(0, true);
  for (int i = 0; i < 200'000; ++i) chain = list_of(heap, chain);
  const std::uint64_t full = heap.used();
  heap.release(many);
  heap.release(chain);
  CHECK(heap.used() > full / 2);
  // More dead ones free more than themselves.
  for (int i = 0; i < 20; ++i) heap.release(heap.new_text("another"));
  const std::uint64_t less = heap.used();
  CHECK(less < full);
  // These have room only where the dead ones were.
  ListObj* others = heap.new_list(400'000, true);
  REQUIRE(others != nullptr);
  bool all = true;
  for (std::uint32_t i = 0; i < others->size; ++i) {
    others->data[i].o = heap.new_text("item");
    all = all && others->data[i].o != nullptr;
  }
  CHECK(all);
  heap.release(others);
  heap.drain();
  CHECK(heap.used() == 0);
}

TEST_CASE("owning a shared list copies it and counts its items") {
  Heap heap(kPlenty);
  TextObj* text = heap.new_text("item");
  Slot a = slot_of(static_cast<Obj*>(list_of(heap, text)));
  Slot b = a;
  retain_object(b.o);
  REQUIRE(copy_shared(heap, b));
  CHECK(a.o != b.o);
  CHECK(a.o->refs == 1);
  CHECK(text->refs == 2);
  REQUIRE(b.o->refs == 1);  // now the only owner
  heap.release(a.o);
  heap.release(b.o);
  CHECK(heap.used() == 0);
}

TEST_CASE("records own the fields that are references") {
  Heap heap(kPlenty);
  const std::vector<std::uint16_t> references{1};
  const RecordLayout layout{nullptr, 2, references};
  RecordObj* record = heap.new_record(layout);
  record->fields()[0].i = 7;
  record->fields()[1].o = heap.new_text("field");
  Slot copy = slot_of(static_cast<Obj*>(record));
  retain_object(record);
  REQUIRE(copy_shared(heap, copy));
  CHECK(static_cast<RecordObj*>(copy.o)->fields()[0].i == 7);
  heap.release(copy.o);
  heap.release(record);
  CHECK(heap.used() == 0);
}

TEST_CASE("closures and boxes own what they hold") {
  Heap heap(kPlenty);
  const std::vector<std::uint16_t> references{0};
  ClosureObj* closure = heap.new_closure(3, 2, &references);
  BoxObj* box = heap.new_box(true);
  box->value.o = heap.new_text("boxed");
  closure->captures()[0].o = box;
  closure->captures()[1].d = 0.5;
  heap.release(closure);
  CHECK(heap.used() == 0);
}

TEST_CASE("values of the host are destroyed once") {
  static int alive = 0;
  struct Probe {
    Probe() { ++alive; }
    ~Probe() { --alive; }
  };
  HostType type{};
  type.size = sizeof(Probe);
  type.destroy = [](void* value) { static_cast<Probe*>(value)->~Probe(); };
  Heap heap(kPlenty);
  HostObj* host = heap.new_host(type);
  new (host->payload()) Probe();
  retain_object(host);
  heap.release(host);
  CHECK(alive == 1);
  heap.release(host);
  CHECK(alive == 0);
  CHECK(heap.used() == 0);
}

TEST_CASE("text grows in place while it has one owner") {
  Heap heap(kPlenty);
  Slot place = slot_of(static_cast<Obj*>(heap.new_text("")));
  const TextObj* tail = heap.new_text("ab");
  int moves = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Obj* before = place.o;
    REQUIRE(append_text(heap, place, *tail));
    if (place.o != before) ++moves;
  }
  CHECK(static_cast<TextObj*>(place.o)->size == 20'000);
  CHECK(moves < 40);

  Slot other = place;
  retain_object(other.o);
  REQUIRE(append_text(heap, other, *tail));
  CHECK(static_cast<TextObj*>(place.o)->size == 20'000);
  CHECK(static_cast<TextObj*>(other.o)->size == 20'002);
  heap.release(place.o);
  heap.release(other.o);
  heap.release(const_cast<TextObj*>(tail));
  CHECK(heap.used() == 0);
}

TEST_CASE("a text can be added to itself") {
  Heap heap(kPlenty);
  Slot place = slot_of(static_cast<Obj*>(heap.new_text("abc")));
  for (int i = 0; i < 3; ++i) REQUIRE(append_text(heap, place, *static_cast<TextObj*>(place.o)));
  CHECK(static_cast<TextObj*>(place.o)->view() == "abcabcabcabcabcabcabcabc");
  heap.release(place.o);
  CHECK(heap.used() == 0);
}

TEST_CASE("characters are code points") {
  Heap heap(kPlenty);
  TextObj* text = heap.new_text("a\xC3\xA4z\xE2\x82\xAC");
  CHECK(character_count(*text) == 4);
  CHECK(offset_in(text->view(), 0) == 0);
  CHECK(offset_in(text->view(), 2) == 3);
  CHECK(offset_in(text->view(), 4) == text->size);
  heap.release(text);
}

TEST_CASE("any allocation may be refused without a leak") {
  for (std::uint64_t n = 1; n < 12; ++n) {
    Heap heap(kPlenty);
    heap.refuse_from(n);
    Slot place = slot_of(static_cast<Obj*>(heap.new_list(2, true)));
    if (place.o != nullptr) {
      for (int i = 0; i < 5; ++i) {
        ListObj& list = *static_cast<ListObj*>(place.o);
        Obj* item = heap.new_text("an item");
        if (item == nullptr || !reserve_list(heap, list, list.size + 1)) {
          heap.release(item);
          break;
        }
        list.data[list.size++].o = item;
      }
    }
    heap.release(place.o);
    CHECK(heap.used() == 0);
  }
}
