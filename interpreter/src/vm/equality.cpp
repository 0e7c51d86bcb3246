#include "vm/equality.hpp"

#include <algorithm>
#include <vector>

namespace armlet::lang {

namespace {

struct Pair {
  Slot a;
  Slot b;
  const Type* type;
};

bool equal_matrices(const MatrixObj& a, const MatrixObj& b) {
  const std::size_t count = std::size_t{a.rows} * a.cols;
  return a.rows == b.rows && a.cols == b.cols && std::equal(a.data(), a.data() + count, b.data());
}

bool equal_hosts(const HostObj& a, const HostObj& b) {
  return &a == &b || (a.type->equal != nullptr && a.type->equal(a.payload(), b.payload()));
}

void open_items(const ListObj& a, const ListObj& b, const Type* element, std::vector<Pair>& open) {
  for (std::uint32_t i = a.size; i-- > 0;) open.push_back({a.data[i], b.data[i], element});
}

void open_fields(const RecordObj& a, const RecordObj& b, const RecordInfo& info,
                 std::vector<Pair>& open) {
  for (std::size_t i = info.fields.size(); i-- > 0;) {
    open.push_back({a.fields()[i], b.fields()[i], info.fields[i].type});
  }
}

// Compares what lies at hand; parts that are values themselves are left in `open`.
bool equal_so_far(const Pair& pair, std::vector<Pair>& open) {
  const auto [a, b, type] = pair;
  if (type->is(Kind::kReal)) return a.d == b.d;
  if (!type->is_reference()) return a.i == b.i;
  if (a.o == nullptr || b.o == nullptr) return a.o == b.o;
  switch (type->kind) {
    case Kind::kText:
      return static_cast<TextObj*>(a.o)->view() == static_cast<TextObj*>(b.o)->view();
    case Kind::kMatrix:
      return equal_matrices(*static_cast<MatrixObj*>(a.o), *static_cast<MatrixObj*>(b.o));
    case Kind::kHost:
      return equal_hosts(*static_cast<HostObj*>(a.o), *static_cast<HostObj*>(b.o));
    case Kind::kList: {
      const auto& left = *static_cast<ListObj*>(a.o);
      const auto& right = *static_cast<ListObj*>(b.o);
      if (left.size != right.size) return false;
      open_items(left, right, type->element, open);
      return true;
    }
    case Kind::kRecord:
      if (type->is_table()) return a.o == b.o;  // a handle
      open_fields(*static_cast<RecordObj*>(a.o), *static_cast<RecordObj*>(b.o), *type->record,
                  open);
      return true;
    default:
      return a.o == b.o;  // functions
  }
}

}  // namespace

bool equal_values(Slot a, Slot b, const Type& type) {
  std::vector<Pair> open{{a, b, &type}};
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    if (!equal_so_far(pair, open)) return false;
  }
  return true;
}

}  // namespace armlet::lang
