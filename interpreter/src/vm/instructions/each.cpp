#include "vm/instructions/each.hpp"

#include <algorithm>

namespace armlet::lang {

namespace {

const ListObj& list_in(Slot s) { return *static_cast<const ListObj*>(s.o); }
ListObj& changed_list_in(Slot s) { return *static_cast<ListObj*>(s.o); }
bool has(const ListObj& list, std::int64_t index) {
  return static_cast<std::uint64_t>(index) < list.size;
}

// The remaining iterations of the loop whose counting instruction follows the given instruction.
class Passes {
 public:
  Passes(StepMeter& steps, Slot* base, const Instr& loop)
      : steps_(steps), loop_(loop), counter_(base[loop.a].i) {
    const bool small = loop.op == OpCode::FORBYLTK_LOOP || loop.op == OpCode::FORLEK_LOOP;
    const bool reaches = loop.op == OpCode::FORLE_LOOP || loop.op == OpCode::FORLEK_LOOP;
    if (loop.op == OpCode::FORBYLT_LOOP || loop.op == OpCode::FORBYLTK_LOOP) by_ = base[loop.c].i;
    const std::int64_t limit = small ? static_cast<std::int16_t>(loop.b) : base[loop.b].i;
    if (by_ <= 0 || counter_ >= limit) return;
    std::uint64_t passes = static_cast<std::uint64_t>(limit) - static_cast<std::uint64_t>(counter_);
    if (!reaches) --passes;
    if (by_ > 1) passes /= static_cast<std::uint64_t>(by_);
#ifndef ARMLET_UNCOUNTED
    passes = std::min(passes, static_cast<std::uint64_t>(steps.left));
#endif
    most_ = static_cast<std::int64_t>(passes);
  }

  // The most iterations that can follow the current one.
  [[nodiscard]] std::int64_t most() const { return most_; }
  [[nodiscard]] bool is_counter(std::uint16_t reg) const { return reg == loop_.a; }
  // How much an index increases in each iteration: as much as the counter, or nothing.
  [[nodiscard]] std::int64_t stride(std::uint16_t reg) const { return is_counter(reg) ? by_ : 0; }
  void finish(std::int64_t done) {
    counter_ += done * by_;
#ifndef ARMLET_UNCOUNTED
    steps_.left -= done;
#endif
  }

 private:
  StepMeter& steps_;
  const Instr& loop_;
  std::int64_t& counter_;
  std::int64_t by_ = 1;
  std::int64_t most_ = 0;
};

// An index that increases in each iteration.
struct Index {
  Index(const Passes& passes, const Slot* base, std::uint16_t reg)
      : at(base[reg].i), by(passes.stride(reg)) {}
  void move() { at += by; }
  std::int64_t at;
  std::int64_t by;
};

double finish_sum(Passes& passes, std::int64_t done, Slot& to, double sum) {
  passes.finish(done);
  to.d = sum;
  return sum;
}

template <class Change>
void change_each(StepMeter& steps, Slot* base, const Instr* pc, Change change) {
  Passes passes(steps, base, pc[3]);
  ListObj& x = changed_list_in(base[pc->a]);
  const ListObj& y = list_in(base[pc[1].a]);
  Index i(passes, base, pc->b);
  Index j(passes, base, pc[1].b);
  const double factor = base[pc->c].d;
  std::int64_t done = 0;
  if (x.refs == 1) {
    for (; done < passes.most() && has(x, i.at) && has(y, j.at); ++done, i.move(), j.move()) {
      change(x.data[i.at].d, factor * y.data[j.at].d);
    }
  }
  passes.finish(done);
}

}  // namespace

double add_each(StepMeter& steps, Slot* base, const Instr* pc, double sum) {
  Passes passes(steps, base, pc[2]);
  const ListObj& x = list_in(base[pc->b]);
  Index i(passes, base, pc->c);
  std::int64_t done = 0;
  for (; done < passes.most() && has(x, i.at); ++done, i.move()) sum = sum + x.data[i.at].d;
  return finish_sum(passes, done, base[pc->a], sum);
}

double add_product_each(StepMeter& steps, Slot* base, const Instr* pc, double sum) {
  Passes passes(steps, base, pc[2]);
  const ListObj& x = list_in(base[pc->b]);
  Index i(passes, base, pc->c);
  const double factor = base[pc[1].a].d;
  std::int64_t done = 0;
  for (; done < passes.most() && has(x, i.at); ++done, i.move()) {
    sum = sum + factor * x.data[i.at].d;
  }
  return finish_sum(passes, done, base[pc->a], sum);
}

double add_product_of_two_each(StepMeter& steps, Slot* base, const Instr* pc, double sum) {
  Passes passes(steps, base, pc[2]);
  const ListObj& x = list_in(base[pc->b]);
  const ListObj& y = list_in(base[pc[1].a]);
  Index i(passes, base, pc->c);
  Index j(passes, base, pc[1].b);
  std::int64_t done = 0;
  for (; done < passes.most() && has(x, i.at) && has(y, j.at); ++done, i.move(), j.move()) {
    sum = sum + x.data[i.at].d * y.data[j.at].d;
  }
  return finish_sum(passes, done, base[pc->a], sum);
}

double add_product_with_row_each(StepMeter& steps, Slot* base, const Instr* pc, double sum) {
  Passes passes(steps, base, pc[3]);
  const ListObj& x = list_in(base[pc->b]);
  const ListObj& rows = list_in(base[pc[1].a]);
  Index i(passes, base, pc->c);
  Index j(passes, base, pc[1].b);
  Index k(passes, base, pc[2].a);
  std::int64_t done = 0;
  for (; done < passes.most() && has(x, i.at) && has(rows, j.at); ++done) {
    const ListObj& row = list_in(rows.data[j.at]);
    if (!has(row, k.at)) break;
    sum = sum + x.data[i.at].d * row.data[k.at].d;
    i.move();
    j.move();
    k.move();
  }
  return finish_sum(passes, done, base[pc->a], sum);
}

void add_int_each(StepMeter& steps, Slot* base, const Instr* pc) {
  Passes passes(steps, base, pc[2]);
  const ListObj& x = list_in(base[pc->b]);
  Index i(passes, base, pc->c);
  std::int64_t sum = base[pc->a].i;
  std::int64_t done = 0;
  for (; done < passes.most() && has(x, i.at); ++done, i.move()) {
    std::int64_t next = 0;
    if (__builtin_add_overflow(sum, x.data[i.at].i, &next)) break;
    sum = next;
  }
  passes.finish(done);
  base[pc->a].i = sum;
}

// The ordinary instruction copies a list with several owners first, so this fast form is only for
// lists with one owner.
void store_each(StepMeter& steps, Slot* base, const Instr* pc) {
  Passes passes(steps, base, pc[1]);
  const ListObj& x = list_in(base[pc->a]);
  Index i(passes, base, pc->b);
  Slot value = base[pc->c];
  const std::int64_t more = passes.stride(pc->c);
  std::int64_t done = 0;
  if (x.refs == 1) {
    for (; done < passes.most() && has(x, i.at); ++done, i.move()) {
      x.data[i.at] = value;
      value.i += more;
    }
  }
  passes.finish(done);
}

void copy_each(StepMeter& steps, Slot* base, const Instr* pc) {
  Passes passes(steps, base, pc[2]);
  const ListObj& from = list_in(base[pc->b]);
  const ListObj& to = list_in(base[pc[1].a]);
  Index j(passes, base, pc->c);
  Index i(passes, base, pc[1].b);
  std::int64_t done = 0;
  if (to.refs == 1) {
    for (; done < passes.most() && has(from, j.at) && has(to, i.at); ++done, i.move(), j.move()) {
      to.data[i.at] = from.data[j.at];
    }
  }
  passes.finish(done);
}

void update_each(StepMeter& steps, Slot* base, const Instr* pc) {
  change_each(steps, base, pc,
              [](double& element, double product) { element = element + product; });
}

void update_minus_each(StepMeter& steps, Slot* base, const Instr* pc) {
  change_each(steps, base, pc,
              [](double& element, double product) { element = element - product; });
}

}  // namespace armlet::lang
