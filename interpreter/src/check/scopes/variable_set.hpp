#pragma once
// Sets of variables that are copied at every branch of a program. Copies share equal parts, and a
// union visits only the parts that differ.
//
// Big-endian Patricia trees: Okasaki and Gill, "Fast mergeable integer maps", ML Workshop 1998.

#include <cstdint>
#include <memory>

#include "hir/hir.hpp"

namespace armlet::lang {

class VariableSet {
 public:
  [[nodiscard]] bool empty() const { return root_ == nullptr; }
  [[nodiscard]] bool contains(const hir::Variable* variable) const;
  void insert(const hir::Variable* variable);
  void erase(const hir::Variable* variable);
  // Adds the elements of the other set (union).
  void unite(const VariableSet& other) { root_ = united(root_, other.root_); }
  // Removes the elements that the other set does not have (intersection).
  void intersect(const VariableSet& other) { root_ = common(root_, other.root_); }

 private:
  struct Node;
  using Tree = std::shared_ptr<const Node>;
  using Key = std::uint64_t;

  // A leaf has branch 0 and one key. An inner node splits keys by the bit `branch`; above that bit
  // all of its keys are equal.
  struct Node {
    Key key = 0;
    Key branch = 0;  // a single bit
    Tree zero{};
    Tree one{};
  };

  static Key key_of(const hir::Variable* variable);
  static bool belongs(Key key, const Node& node);
  static bool has(const Node* at, Key key);
  static Tree leaf(Key key);
  static Tree joined(const Tree& a, const Tree& b);
  static Tree with_parts(const Tree& whole, Tree zero, Tree one);
  static Tree inserted(const Tree& tree, Key key);
  static Tree erased(const Tree& tree, Key key);
  static Tree united(const Tree& a, const Tree& b);
  static Tree common(const Tree& a, const Tree& b);

  Tree root_{};
};

}  // namespace armlet::lang
