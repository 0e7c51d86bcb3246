#include "armlet/backend/backend.hpp"

namespace armlet {

std::string_view to_text(ObjectChange change) {
  switch (change) {
    case ObjectChange::kAttached:
      return "attached";
    case ObjectChange::kDetached:
      return "detached";
    case ObjectChange::kRemoved:
      return "removed";
    case ObjectChange::kFell:
      return "fell";
  }
  return "";
}

std::string_view to_text(NoteKind kind) {
  switch (kind) {
    case NoteKind::kOutput:
      return "output";
    case NoteKind::kMessage:
      return "message";
    case NoteKind::kAdvice:
      return "advice";
  }
  return "";
}

}  // namespace armlet
