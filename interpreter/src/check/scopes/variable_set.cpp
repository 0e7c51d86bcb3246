#include "check/scopes/variable_set.hpp"

#include <bit>
#include <utility>

namespace armlet::lang {

VariableSet::Key VariableSet::key_of(const hir::Variable* variable) {
  return static_cast<Key>(reinterpret_cast<std::uintptr_t>(variable));
}

// Whether a key may be in the subtree of the node.
bool VariableSet::belongs(Key key, const Node& node) {
  const Key above = ~(node.branch | (node.branch - 1));
  return node.branch == 0 ? key == node.key : (key & above) == (node.key & above);
}

bool VariableSet::has(const Node* at, Key key) {
  while (at != nullptr && at->branch != 0) {
    if (!belongs(key, *at)) return false;
    at = (key & at->branch) == 0 ? at->zero.get() : at->one.get();
  }
  return at != nullptr && at->key == key;
}

VariableSet::Tree VariableSet::leaf(Key key) {
  return std::make_shared<const Node>(Node{.key = key});
}

// Joins two trees whose keys differ in a bit above the branches of both.
VariableSet::Tree VariableSet::joined(const Tree& a, const Tree& b) {
  const Key branch = std::bit_floor(a->key ^ b->key);
  const bool a_first = (a->key & branch) == 0;
  return std::make_shared<const Node>(Node{a->key, branch, a_first ? a : b, a_first ? b : a});
}

// The node with other subtrees; the node itself if they are the same.
VariableSet::Tree VariableSet::with_parts(const Tree& whole, Tree zero, Tree one) {
  if (zero == whole->zero && one == whole->one) return whole;
  if (zero == nullptr) return one;
  if (one == nullptr) return zero;
  return std::make_shared<const Node>(
      Node{whole->key, whole->branch, std::move(zero), std::move(one)});
}

VariableSet::Tree VariableSet::inserted(const Tree& tree, Key key) {
  if (tree == nullptr) return leaf(key);
  if (!belongs(key, *tree)) return joined(tree, leaf(key));
  if (tree->branch == 0) return tree;
  if ((key & tree->branch) == 0) return with_parts(tree, inserted(tree->zero, key), tree->one);
  return with_parts(tree, tree->zero, inserted(tree->one, key));
}

VariableSet::Tree VariableSet::erased(const Tree& tree, Key key) {
  if (tree == nullptr || !belongs(key, *tree)) return tree;
  if (tree->branch == 0) return nullptr;
  if ((key & tree->branch) == 0) return with_parts(tree, erased(tree->zero, key), tree->one);
  return with_parts(tree, tree->zero, erased(tree->one, key));
}

VariableSet::Tree VariableSet::united(const Tree& a, const Tree& b) {
  if (a == b || b == nullptr) return a;
  if (a == nullptr) return b;
  if (b->branch == 0) return inserted(a, b->key);
  if (a->branch == 0) return inserted(b, a->key);
  if (a->branch == b->branch && belongs(b->key, *a)) {
    Tree zero = united(a->zero, b->zero);
    Tree one = united(a->one, b->one);
    if (zero == b->zero && one == b->one) return b;
    return with_parts(a, std::move(zero), std::move(one));
  }
  if (a->branch < b->branch) return united(b, a);
  if (!belongs(b->key, *a)) return joined(a, b);
  if ((b->key & a->branch) == 0) return with_parts(a, united(a->zero, b), a->one);
  return with_parts(a, a->zero, united(a->one, b));
}

VariableSet::Tree VariableSet::common(const Tree& a, const Tree& b) {
  if (a == b) return a;
  if (a == nullptr || b == nullptr) return nullptr;
  if (a->branch == 0) return has(b.get(), a->key) ? a : nullptr;
  if (b->branch == 0) return has(a.get(), b->key) ? b : nullptr;
  if (a->branch == b->branch) {
    if (!belongs(b->key, *a)) return nullptr;
    return with_parts(a, common(a->zero, b->zero), common(a->one, b->one));
  }
  if (a->branch < b->branch) return common(b, a);
  if (!belongs(b->key, *a)) return nullptr;
  return common((b->key & a->branch) == 0 ? a->zero : a->one, b);
}

bool VariableSet::contains(const hir::Variable* variable) const {
  return has(root_.get(), key_of(variable));
}
void VariableSet::insert(const hir::Variable* variable) {
  root_ = inserted(root_, key_of(variable));
}
void VariableSet::erase(const hir::Variable* variable) { root_ = erased(root_, key_of(variable)); }

}  // namespace armlet::lang
