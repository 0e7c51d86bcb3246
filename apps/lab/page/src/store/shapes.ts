// The dimensions of objects; sizes are those of the protocol.
import type { ObjectInfo } from "../protocol/messages.ts";

// The distances from the middle to the sides along the axes of the object, m.
export function halfExtents(object: ObjectInfo): [number, number, number] {
  const [a = 0, b = a, c = a] = object.size;
  switch (object.shape) {
    case "box":
    case "mesh": // its bounding box
      return [a / 2, b / 2, c / 2];
    case "plane":
      return [a / 2, b / 2, 0];
    case "cylinder":
    case "cone":
      return [a, a, b / 2];
    default:
      return [a, a, a];
  }
}

// Whether it looks the same from all sides.
export function isRound(object: ObjectInfo): boolean {
  return ["cylinder", "sphere", "cone"].includes(object.shape);
}
