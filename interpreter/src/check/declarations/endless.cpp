#include "check/declarations/endless.hpp"

#include <algorithm>

#include "check/state/checker.hpp"

namespace armlet::lang {
namespace {

// Finds cycles of records that contain each other (R. Tarjan, "Depth-first search and linear graph
// algorithms", SIAM J. Comput. 1972). It uses a stack of its own, because the cycles may be long.
class Circles {
 public:
  void look_from(const RecordInfo* first) {
    if (numbers_.contains(first)) return;
    enter(first);
    while (!open_.empty()) {
      Visit& top = open_.back();
      if (top.next == top.record->fields.size()) {
        leave();
        continue;
      }
      const Type* type = top.record->fields[top.next++].type;
      if (!type->is(Kind::kRecord)) continue;
      if (type->record == top.record) endless_.insert(top.record);
      const auto known = numbers_.find(type->record);
      if (known == numbers_.end()) {
        enter(type->record);
      } else if (waiting_.contains(type->record)) {
        top.lowest = std::min(top.lowest, known->second);
      }
    }
  }

  [[nodiscard]] bool has(const RecordInfo* record) const { return endless_.contains(record); }

 private:
  struct Visit {
    const RecordInfo* record;
    std::size_t next;    // index of the next field
    std::size_t lowest;  // the smallest number that is reachable
  };

  void enter(const RecordInfo* record) {
    const std::size_t number = numbers_.size();
    numbers_.emplace(record, number);
    waiting_.insert(record);
    component_.push_back(record);
    open_.push_back({record, 0, number});
  }

  void leave() {
    const Visit done = open_.back();
    open_.pop_back();
    if (!open_.empty()) open_.back().lowest = std::min(open_.back().lowest, done.lowest);
    if (done.lowest != numbers_.at(done.record)) return;
    const bool alone = component_.back() == done.record;
    while (true) {
      const RecordInfo* member = component_.back();
      component_.pop_back();
      waiting_.erase(member);
      if (!alone) endless_.insert(member);
      if (member == done.record) return;
    }
  }

  std::unordered_map<const RecordInfo*, std::size_t> numbers_;
  std::unordered_set<const RecordInfo*> waiting_;
  std::vector<const RecordInfo*> component_;
  std::vector<Visit> open_;
  std::unordered_set<const RecordInfo*> endless_;
};

}  // namespace

void refuse_endless(Checker& checker) {
  Circles circles;
  for (const auto& [name, type] : checker.names.types()) {
    if (!type->is(Kind::kRecord)) continue;
    circles.look_from(type->record);
    if (!circles.has(type->record)) continue;
    const ast::Name& written = checker.shared.structs.find(type)->node->name;
    checker.messages.begin_statement();
    checker.report(make_diagnostic("E0333", written.span, {std::string(written.text)}));
  }
}

}  // namespace armlet::lang
