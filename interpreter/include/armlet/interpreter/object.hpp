#pragma once
// The values of a running program: slots of eight bytes, and objects with reference counts.
//
// Types exist only in the checker, so a slot has no tag: the checked program determines its type. A
// reference in a variable or a container owns one count. Objects with more than one count are never
// changed, so that lists and records behave as values. Cycles are impossible, so counting is
// sufficient.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace armlet {

struct Type;
struct Obj;
struct ResourceWords;

union Slot {
  double d;
  std::int64_t i;
  Obj* o;
};
static_assert(sizeof(Slot) == 8);

[[nodiscard]] inline Slot slot_of(double d) { return Slot{.d = d}; }
[[nodiscard]] inline Slot slot_of(std::int64_t i) { return Slot{.i = i}; }
[[nodiscard]] inline Slot slot_of(bool b) { return Slot{.i = b ? 1 : 0}; }
[[nodiscard]] inline Slot slot_of(Obj* o) { return Slot{.o = o}; }

// The slot of an absent optional argument: a null reference, or these bits (a NaN that no
// arithmetic makes).
inline constexpr std::int64_t kAbsentBits = static_cast<std::int64_t>(0xFFF8'A851'7000'0001ULL);
[[nodiscard]] inline bool is_absent_scalar(Slot s) { return s.i == kAbsentBits; }

enum class ObjKind : std::uint8_t { kText, kList, kMap, kRecord, kMatrix, kClosure, kBox, kHost };

// Aligned so that slots can follow any header, also with 32-bit addresses.
struct alignas(Slot) Obj {
  std::uint32_t refs;
  ObjKind kind;
  std::uint8_t flags;
  std::uint16_t extra;
};

// A text: UTF-8 without a final zero. The characters are counted at the first request.
struct TextObj : Obj {
  static constexpr std::uint32_t kUncounted = 0xFFFFFFFFU;
  std::uint32_t size;        // bytes
  std::uint32_t capacity;    // bytes
  std::uint32_t characters;  // or kUncounted
  std::uint32_t marks;       // index of a table of the heap for finding characters; 0: none yet
  [[nodiscard]] char* data() { return reinterpret_cast<char*>(this + 1); }
  [[nodiscard]] const char* data() const { return reinterpret_cast<const char*>(this + 1); }
  [[nodiscard]] std::string_view view() const { return {data(), size}; }
};

// A list. The elements of a short list follow the header; `data` always refers to the elements.
struct ListObj : Obj {
  static constexpr std::uint8_t kReferences =
      1;  // flag: elements are references; other bits belong to the heap
  std::uint32_t size;
  std::uint32_t capacity;
  Slot* data;
  [[nodiscard]] bool holds_references() const { return (flags & kReferences) != 0; }
  // The elements of a list of numbers.
  [[nodiscard]] std::span<const double> reals() const {
    return {reinterpret_cast<const double*>(data), size};
  }
};

struct MapEntry {
  Slot key;
  Slot value;
  std::uint32_t hash;
  bool is_removed;  // key and value are then null
};

// A map: entries in the order of their insertion. They are followed, in the same block, by an index
// of twice their capacity that is searched by the hash of a key: each index slot has the number of
// an entry, counted from 1, or 0. Only vm/values/map.hpp changes the entries.
struct MapObj : Obj {
  static constexpr std::uint8_t kReferences = 1;  // flag: the values are references
  static constexpr std::uint8_t kTextKeys = 2;    // flag: the keys are texts
  std::uint32_t size;                             // entries that are not removed
  std::uint32_t used;                             // entries, removed ones included
  std::uint32_t capacity;                         // a power of two, or 0
  MapEntry* entries;
  [[nodiscard]] bool holds_references() const { return (flags & kReferences) != 0; }
  [[nodiscard]] bool has_text_keys() const { return (flags & kTextKeys) != 0; }
  [[nodiscard]] std::span<const MapEntry> all() const { return {entries, used}; }
};

// The layout of the fields of a record or of the captures of a closure.
struct RecordLayout {
  const Type* type = nullptr;                 // the record's type
  std::uint16_t size = 0;                     // slots
  std::span<const std::uint16_t> references;  // indices of the slots that are references
};

struct RecordObj : Obj {
  const RecordLayout* layout;
  [[nodiscard]] Slot* fields() { return reinterpret_cast<Slot*>(this + 1); }
  [[nodiscard]] const Slot* fields() const { return reinterpret_cast<const Slot*>(this + 1); }
};

// Row-major (the language's A[i, j]); inline after the header.
struct MatrixObj : Obj {
  std::uint32_t rows;
  std::uint32_t cols;
  [[nodiscard]] double* data() { return reinterpret_cast<double*>(this + 1); }
  [[nodiscard]] const double* data() const { return reinterpret_cast<const double*>(this + 1); }
};

// A function value: the function, and copies (or boxes) of the outer variables that it uses. extra
// = count of captures.
struct ClosureObj : Obj {
  std::uint32_t function;
  std::uint32_t reserved;
  [[nodiscard]] Slot* captures() { return reinterpret_cast<Slot*>(this + 1); }
  [[nodiscard]] const Slot* captures() const { return reinterpret_cast<const Slot*>(this + 1); }
};

// A variable shared between a block and the conditions or tasks inside it. flags == 1: its value is
// a reference.
struct BoxObj : Obj {
  Slot value;
};

// A type that the host defines. Values are immutable; a handle stands for one thing.
struct HostType {
  std::string_view name;
  std::uint32_t size = 0;  // bytes of the payload, at most 16-aligned
  bool is_handle = false;
  bool is_ambient = false;                 // may be absent as the first argument (section 5)
  void (*destroy)(void* value) = nullptr;  // null: trivially destructible
  bool (*equal)(const void* a, const void* b) = nullptr;        // null: no ==
  void (*text)(const void* value, std::string& out) = nullptr;  // as print shows it
  std::string_view help;
  // Words for messages about values of another type: "a position", "moves to a target, an object
  // made from the numbers".
  std::string_view noun = {};
  std::string_view use = {};
  // For types declared by `type<T>`: the HostType of values that C++ code makes, which is known
  // from T alone.
  const HostType* in_cpp = nullptr;
  // The words of a resource, which only one task at a time may command (resource.hpp); null: no
  // resource.
  const ResourceWords* resource = nullptr;
  // Constructs a copy at `to`, for hosts that read such values; null: values cannot be copied.
  void (*copy)(const void* from, void* to) = nullptr;
};

// Whether the values of two types are the same C++ type.
[[nodiscard]] constexpr bool is_same_in_cpp(const HostType* a, const HostType* b) {
  const auto carried = [](const HostType* type) {
    return type != nullptr && type->in_cpp != nullptr ? type->in_cpp : type;
  };
  return carried(a) == carried(b);
}

struct HostObj : Obj {
  std::uint32_t reserved;
  const HostType* type;
  [[nodiscard]] void* payload() { return reinterpret_cast<std::byte*>(this) + kPayloadOffset; }
  [[nodiscard]] const void* payload() const {
    return reinterpret_cast<const std::byte*>(this) + kPayloadOffset;
  }
  static constexpr std::size_t kPayloadOffset = 32;
};

}  // namespace armlet
