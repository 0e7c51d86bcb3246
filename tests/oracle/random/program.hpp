#pragma once
// Writes random programs that pass the checker, by number: the same number is the same program
// everywhere.
//
// They try to be unpleasant to a compiler: lists that share their storage until one is changed,
// functions that change what is being read, failures in the middle of everything, exits through
// finally, ints near their ends, tasks that change what others have half read.

#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace armlet::oracle {

enum class Sort : std::uint8_t {
  kInt,
  kReal,
  kBool,
  kText,
  kLength,
  kAngle,
  kTime,
  kList,
  kMap,
  kStruct,
  kEnum,
  kFunction
};

struct Ty {
  Sort sort;
  std::string name;             // as the program writes it
  const Ty* element = nullptr;  // kList, kMap
  std::size_t id = 0;           // kStruct, kEnum: which
  std::vector<const Ty*> parameters{};
  const Ty* result = nullptr;
  const Ty* key = nullptr;  // kMap

  [[nodiscard]] bool is(Sort s) const { return sort == s; }
  [[nodiscard]] bool is_list_of(Sort s) const { return sort == Sort::kList && element->sort == s; }
  [[nodiscard]] bool is_quantity() const {
    return sort == Sort::kLength || sort == Sort::kAngle || sort == Sort::kTime;
  }
  [[nodiscard]] bool is_floating() const { return sort == Sort::kReal || is_quantity(); }
};

class RandomProgram {
 public:
  explicit RandomProgram(std::uint64_t number)
      : random_(std::mt19937_64(number * 0x9E3779B97F4A7C15ULL + 1)) {}
  // Choices taken from elsewhere.
  explicit RandomProgram(std::function<std::uint64_t()> random) : random_(std::move(random)) {}

  // One that has tasks; otherwise every fourth has.
  RandomProgram& with_tasks() {
    tasks_wanted_ = true;
    return *this;
  }
  std::string text();

 private:
  struct Var {
    std::string name;
    const Ty* type;
    bool can_change;
  };
  struct Field {
    std::string name;
    const Ty* type;
    std::string first;  // its default; "": none
  };
  struct Struct {
    const Ty* type;
    std::vector<Field> fields;
    bool comparable = true;
  };
  struct Function {
    std::string name;
    std::vector<Field> parameters;
    const Ty* result;
    bool is_generic = false;
  };

  // ---- chance
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class T>
  const T& one_of(const std::vector<T>& items) {
    return items[below(items.size())];
  }
  std::string fresh() { return "v" + std::to_string(++names_); }

  // ---- types
  void make_types();
  const Ty* list_of(const Ty* element);
  const Ty* function_type(std::vector<const Ty*> parameters, const Ty* result);
  const Ty* scalar();    // int, double, bool, text, a quantity, an enum
  const Ty* storable();  // also lists and structs
  [[nodiscard]] bool comparable(const Ty* type) const;

  // ---- the whole (program.cpp)
  void declare_types();
  void declare_struct();
  void declare_globals();
  void declare_helpers();
  void declare_function();
  void declare_generic();
  void declare_leaf();
  void declare_recursive();
  void declare_late();
  std::string constant(const Ty* type);
  void line(const std::string& text) { out_ += text + "\n"; }

  // ---- loops over doubles (kernel.cpp)
  void declare_kernel();
  void kernel_loop();
  void kernel_statement();
  void kernel_fields();
  std::string kernel_term(int depth, const std::string& index);

  // ---- elements and characters as operands, loops of one statement (operands.cpp)
  void declare_operands();
  void operand_statement();
  void operand_loop();
  std::string operand_relation();
  std::string operand_test();

  // ---- values that change their owner (handing.cpp)
  void declare_handing();
  void handing_statement();
  std::string handing_call();

  // ---- elements that are not set yet (unset.cpp)
  void declare_unset();
  void unset_statement();

  // ---- loops over lists that are changed (table.cpp)
  void declare_table();
  void table_loop();
  void table_statement();
  void table_choice();
  std::string table_index(const std::string& base);
  std::string table_int();
  std::string table_real();

  // ---- maps (map.cpp)
  const Ty* map_of(const Ty* key, const Ty* element);
  const Ty* some_map();
  std::string plain_key(const Ty* key, std::size_t i);
  std::string key_of(const Ty* map, int depth);
  std::string map_literal(const Ty* type, int depth);
  // Any key, any element: null.
  const Var* find_map(const Ty* key, const Ty* element, bool to_change);
  std::string from_map(const Ty* type, int depth);
  void map_statement();
  void visit_map(const std::string& name, const Ty* type);

  // ---- names in sight
  std::vector<const Var*> visible(const Ty* type, bool to_change);
  const Var* find(const Ty* type, bool to_change = false);
  const Var* find_list(bool to_change);

  // ---- expressions of exactly the type (expression.cpp)
  std::string expr(const Ty* type, int depth);
  std::string loose(const Ty* type, int depth);  // or one that converts to it by itself
  std::string leaf(const Ty* type);
  std::string literal(const Ty* type);
  std::string integer(int depth);
  std::string checked_sum(const std::string& a, const std::string& b);
  std::string real(int depth);
  std::string new_real(int depth);
  std::string truth(int depth);
  std::string text_expr(int depth);
  std::string quantity(const Ty* type, int depth);
  std::string list(const Ty* type, int depth);
  std::string record(const Ty* type, int depth);
  std::string enum_value(const Ty* type, int depth);
  std::string function_value(const Ty* type);
  std::string lambda(const Ty* type);
  std::string formatted(int depth);
  std::string piece(int depth);
  // A call, an element, a field or a choice that gives this type; "" if there is none in sight.
  std::string from_elsewhere(const Ty* type, int depth);
  std::string call(const Ty* type, int depth);
  std::string call_value(const Ty* type, int depth);
  std::string element(const Ty* type, int depth);
  std::string field(const Ty* type, int depth);
  std::string taken(const Ty* type);
  static std::string index(const std::string& number);
  std::string index_of(const std::string& list, int depth);
  std::string arguments(const Function& function, int depth);

  // ---- statements (statement.cpp, control.cpp)
  void statement();
  void body(int count);
  void simple();
  void declaration();
  void assignment();
  void compound();
  void place_assignment();
  void mutation();
  void grid_assignment();
  std::string stretch();
  std::string visitor(const Ty* element, const Ty* result);
  void aliasing();
  void show();
  void conditional();
  void counted();
  void ranged();
  void visiting();
  void repeating();
  void choosing();
  void guarded();
  void retrying();
  void asserting();
  void leaving();
  void loop_body(const std::string& counter);
  void returning();
  // tasks.cpp
  void concurrent();
  void branches();
  void watching();
  void watch();
  void waiting();
  void task_body(int count);
  std::string condition();
  std::string milliseconds(std::size_t most);
  void open(const std::string& header) { line(header + " {"); }
  void close(const std::string& rest = "") { line("}" + rest); }
  // The target to store something of this type into; "" if there is none.
  std::string place(const Ty* type);
  void keep_short(const std::string& text_name);

  std::function<std::uint64_t()> random_;
  std::string out_;
  std::deque<Ty> types_;
  const Ty *int_ = nullptr, *real_ = nullptr, *bool_ = nullptr, *text_ = nullptr,
           *length_ = nullptr, *angle_ = nullptr, *time_ = nullptr;
  std::vector<const Ty*> enums_;
  std::vector<std::vector<std::string>> enum_values_;
  std::vector<Struct> structs_;
  std::vector<Function> functions_;
  // Expressions that may be written once more, while everything in them is in sight.
  struct Recent {
    std::string text;
    std::string newest;  // variable in sight
    bool in_format;
  };
  std::vector<Recent> recent_;
  std::deque<Var> vars_;              // in sight, innermost last; those found stay where they are
  std::size_t first_changeable_ = 0;  // lambdas cannot change what lies before
  const Ty* result_ = nullptr;  // of the function that is being written; null: the program itself
  int names_ = 0;
  int statements_left_ = 0;
  int loops_ = 0;          // open ones
  int nesting_ = 0;        // of blocks
  int calls_left_ = 0;     // in this statement
  bool has_grid_ = false;  // a matrix called grid
  bool in_format_ = false;
  bool in_lambda_ = false;
  bool can_retry_ = false;
  bool has_tasks_ = false;
  bool tasks_wanted_ = false;
  int tasks_left_ = 0;  // statements that start some
};

}  // namespace armlet::oracle
