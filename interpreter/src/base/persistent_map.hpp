#pragma once
// Persistent maps: adding an entry makes a new map that shares nearly all of the old one, which
// stays unchanged. A session of 10,000 entries keeps 10,000 states of its names in little more
// memory than the last one needs, and a lookup takes a few steps.

#include <bit>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

namespace armlet::lang {

template <class V>
class PersistentMap {
 public:
  using Key = std::uint64_t;

  // The value of a key; null if there is none. Its address is valid as long as a map contains it.
  [[nodiscard]] const V* find(Key key) const {
    const Node* at = root_.get();
    while (at != nullptr && at->branch != 0) {
      if (!belongs(key, *at)) return nullptr;
      at = (key & at->branch) == 0 ? at->zero.get() : at->one.get();
    }
    return at != nullptr && at->key == key ? &at->value : nullptr;
  }

  // Sets the value of a key in this map. Copies that were made before do not change.
  void set(Key key, V value) { root_ = with(root_, leaf(key, std::move(value))); }

  [[nodiscard]] bool is_empty() const { return root_ == nullptr; }

  template <class F>
  void for_each(F f) const {
    visit(root_.get(), f);
  }

 private:
  struct Node;
  using Tree = std::shared_ptr<const Node>;

  // A leaf has branch 0, one key and its value. An inner node splits keys by the bit `branch`;
  // above that bit all of its keys are equal.
  struct Node {
    Key key = 0;
    Key branch = 0;  // a single bit
    Tree zero{};
    Tree one{};
    V value{};
  };

  static bool belongs(Key key, const Node& node) {
    const Key above = ~(node.branch | (node.branch - 1));
    return node.branch == 0 ? key == node.key : (key & above) == (node.key & above);
  }
  static Tree leaf(Key key, V value) {
    return std::make_shared<const Node>(Node{.key = key, .value = std::move(value)});
  }
  static Tree fork(Key key, Key branch, Tree zero, Tree one) {
    return std::make_shared<const Node>(
        Node{.key = key, .branch = branch, .zero = std::move(zero), .one = std::move(one)});
  }
  static Tree with(const Tree& tree, Tree added) {
    if (tree == nullptr) return added;
    const Key key = added->key;
    if (!belongs(key, *tree)) {
      const Key branch = std::bit_floor(tree->key ^ key);
      const bool first = (key & branch) == 0;
      return fork(key, branch, first ? added : tree, first ? tree : added);
    }
    if (tree->branch == 0) return added;
    if ((key & tree->branch) == 0)
      return fork(tree->key, tree->branch, with(tree->zero, std::move(added)), tree->one);
    return fork(tree->key, tree->branch, tree->zero, with(tree->one, std::move(added)));
  }
  template <class F>
  static void visit(const Node* at, F& f) {
    if (at == nullptr) return;
    if (at->branch == 0) return f(at->value);
    visit(at->zero.get(), f);
    visit(at->one.get(), f);
  }

  Tree root_{};
};

// The key for a text: its FNV-1a hash, which is the same in every run. Different texts may have the
// same key, so the values contain their texts.
[[nodiscard]] constexpr std::uint64_t key_of(std::string_view text) {
  std::uint64_t hash = 0xCBF2'9CE4'8422'2325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x0000'0100'0000'01B3ULL;
  }
  return hash;
}
[[nodiscard]] inline std::uint64_t key_of(const void* address) {
  return static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(address));
}

}  // namespace armlet::lang
