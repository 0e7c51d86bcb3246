#include "lower/optimise/flow.hpp"

namespace armlet::lang {

CodeFlow find_flow(const std::vector<WideInstr>& code, const CodeShape& shape) {
  constexpr std::uint32_t kSeveral = CodeFlow::kNone - 1;
  CodeFlow flow{std::vector<bool>(code.size() + 1, false),
                std::vector<std::uint32_t>(code.size() + 1, CodeFlow::kNone)};
  for (const std::uint32_t position : shape.labels) {
    if (position != WideInstr::kNoLabel) flow.targets[position] = true;
  }
  for (const auto& handler : shape.handlers) flow.targets[handler.handler] = true;
  for (std::uint32_t at = 0; at < code.size(); ++at) {
    if (code[at].op != OpCode::LOOP) continue;
    std::uint32_t& end = flow.loop_ends[shape.labels[code[at].label]];
    end = end == CodeFlow::kNone ? at : kSeveral;
  }
  for (std::uint32_t at = 0; at < code.size(); ++at) {
    std::uint32_t& end = flow.loop_ends[at];
    if (end != CodeFlow::kNone && (end == kSeveral || end - at > CodeFlow::kLongestLoop))
      end = CodeFlow::kNone;
  }
  return flow;
}

}  // namespace armlet::lang
