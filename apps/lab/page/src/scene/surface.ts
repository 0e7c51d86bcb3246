// The materials of arms and objects.
import { MeshLambertMaterial, MeshStandardMaterial, type ColorRepresentation, type MeshLambertMaterialParameters } from "three";

export type Surface = MeshStandardMaterial | MeshLambertMaterial;

// A material with this colour and roughness (0: a mirror, 1: chalk); a plain one has no gloss.
export function surface(plain: boolean, color: ColorRepresentation, roughness: number, metalness = 0, further: MeshLambertMaterialParameters = {}): Surface {
  return plain ? new MeshLambertMaterial({ color, ...further }) : new MeshStandardMaterial({ color, roughness, metalness, ...further });
}
