#include "armlet/backend/event.hpp"

#include "armlet/core/hash.hpp"

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

std::string_view to_text(EventKind kind) {
  switch (kind) {
    case EventKind::kBeginRun:
      return "BeginRun";
    case EventKind::kRobotAdded:
      return "RobotAdded";
    case EventKind::kRobotChanged:
      return "RobotChanged";
    case EventKind::kJointSample:
      return "JointSample";
    case EventKind::kObjectAdded:
      return "ObjectAdded";
    case EventKind::kObjectSample:
      return "ObjectSample";
    case EventKind::kObjectEvent:
      return "ObjectEvent";
    case EventKind::kNote:
      return "Note";
    case EventKind::kFigureChanged:
      return "FigureChanged";
    case EventKind::kFinalFigure:
      return "FinalFigure";
    case EventKind::kUndone:
      return "Undone";
    case EventKind::kEndRun:
      return "EndRun";
    case EventKind::kDrawingChanged:
      return "DrawingChanged";
    case EventKind::kCameraAdded:
      return "CameraAdded";
    case EventKind::kImageFrame:
      return "ImageFrame";
  }
  return "";
}

std::uint64_t pixel_hash(const ImageFrame& frame) { return pixel_hash(frame.pixels); }

std::uint64_t pixel_hash(std::span<const std::uint8_t> pixels) {
  Fnv1a hash;
  for (const std::uint8_t byte : pixels) hash.add_byte(byte);
  return hash.value();
}

}  // namespace armlet
