// The layout of values: chains of operators, and lists in brackets.

#include <algorithm>
#include <utility>

#include "ast/marks.hpp"
#include "format/layout.hpp"

namespace armlet::lang {

Doc Layout::expression(const ShapeNode& node, Lead lead) {
  if (node.parts.size() == 3 && node.parts[1].rule == Rule::kToken) {
    if (find_mark(text_of(node.parts[1].token)).chain > 0) return chain(node, lead);
    if (is(node.parts[1], "until")) return choice(node, lead);
  }
  if (node.parts.size() == 5 && is(node.parts[1], "?")) return choice(node, lead);
  return sequence(node, lead, false);
}

// A broken chain has each operator at the start of a line.
Doc Layout::chain(const ShapeNode& node, Lead lead) {
  const auto level_of = [&](const ShapeNode& at) {
    const bool is_binary =
        at.rule == Rule::kExpr && at.parts.size() == 3 && at.parts[1].rule == Rule::kToken;
    return is_binary ? find_mark(text_of(at.parts[1].token)).chain : 0;
  };
  const int level = level_of(node);
  std::vector<const ShapeNode*> links;  // in reverse order
  const ShapeNode* first = &node;
  for (; level_of(*first) == level; first = &first->parts[0]) links.push_back(first);
  const int columns = chain_indent();
  Doc head = this->node(*first, Lead::kDone);
  const bool before = std::exchange(in_header_, false);
  Doc rest;
  for (auto link = links.rbegin(); link != links.rend(); ++link) {
    rest.add(token((*link)->parts[1].token, Lead::kLine));
    rest.add(this->node((*link)->parts[2], Lead::kSpace));
  }
  in_header_ = before;
  Doc inner;
  inner.add(std::move(head));
  inner.add(indent(std::move(rest), columns));
  return behind_lead(node, lead, std::move(inner));
}

// a ? b : c, and motion until condition
Doc Layout::choice(const ShapeNode& node, Lead lead) {
  Doc inner;
  inner.add(this->node(node.parts[0], Lead::kDone));
  Doc rest;
  for (std::size_t i = 1; i + 1 < node.parts.size(); i += 2) {
    rest.add(token(node.parts[i].token, Lead::kLine));
    rest.add(this->node(node.parts[i + 1], Lead::kSpace));
  }
  inner.add(indent(std::move(rest), chain_indent()));
  return behind_lead(node, lead, std::move(inner));
}

// A group without the space before it, which belongs to the text around.
Doc Layout::behind_lead(const ShapeNode& node, Lead lead, Doc inner) const {
  Doc out;
  out.add(lead_of(node.token, lead));
  out.add(group(std::move(inner)));
  return out;
}

// Whether a value is one word, such as -0.5; several of these share a line.
bool Layout::is_short(const ShapeNode& node) const {
  return node.rule == Rule::kToken ||
         (node.rule == Rule::kExpr && node.parts.size() == 2 &&
          node.parts[0].rule == Rule::kToken && node.parts[1].rule == Rule::kToken);
}

// The part from the bracket at part `open` to its closing bracket: on one line if it fits,
// otherwise one item per line. Plain numbers fill their lines, and rows of a matrix have one line
// each. If it is the whole value of an assignment, it keeps a line break that the author made after
// its opening bracket.
Doc Layout::brackets(const ShapeNode& node, std::size_t open, Lead lead, bool is_value) {
  const std::size_t close = closing_part(node, open);
  const std::uint32_t closer = node.parts[close].token;
  std::vector<const ShapeNode*> items;
  for (std::size_t i = open + 1; i < close; ++i) {
    const ShapeNode& part = node.parts[i];
    if (part.rule != Rule::kParams && part.rule != Rule::kRow) {
      items.push_back(&part);
      continue;
    }
    for (const ShapeNode& inner : part.parts) items.push_back(&inner);
  }
  Doc out;
  out.add(token(node.parts[open].token, lead));
  if (items.empty() && !gaps_[closer].has_break()) {
    out.add(comments_at_end(closer, false));
    out.add(text(text_of(closer)));
    return out;
  }

  const bool before = std::exchange(in_header_, false);
  const bool is_matrix = std::ranges::any_of(items, [&](auto* item) { return is(*item, ";"); });
  const bool fills = is_matrix || std::ranges::all_of(items, [&](auto* i) { return is_short(*i); });
  const bool can_open = is_value && !is(node.parts[open], "(");
  bool opened = can_open && gaps_[node.parts[open].token + 1].has_break();
  Doc inner;
  for (std::size_t i = 0; i < items.size(); ++i) {
    Lead here = Lead::kTight;
    if (i == 0) {
      here = Lead::kSoft;
    } else if (is(*items[i - 1], ";")) {
      here = Lead::kLine;
      opened = opened || (can_open && gaps_[items[i]->token].has_break());
    } else if (is(*items[i - 1], ",")) {
      here = fills ? Lead::kFill : Lead::kLine;
    }
    inner.add(this->node(*items[i], here));
  }
  inner.add(comments_at_end(closer, false));
  in_header_ = before;
  Doc lines;
  const bool hugs = inner.body && !opened;  // the statements inside are indented already
  lines.add(indent(std::move(inner), hugs ? 0 : kIndentWidth));
  lines.add(token_without_comments(closer, Lead::kSoft));
  out.add(opened ? body(std::move(lines), false) : group(std::move(lines)));
  return out;
}

}  // namespace armlet::lang
