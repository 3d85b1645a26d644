import {
  BackSide,
  BoxGeometry,
  Color,
  Mesh,
  MeshBasicMaterial,
  PMREMGenerator,
  Scene,
  type Texture,
  type WebGLRenderer,
} from 'three';

/** A lamp of the studio: a glowing board that bricks mirror. Positions in metres about the model. */
interface Lamp {
  readonly at: readonly [number, number, number];
  readonly size: readonly [number, number, number];
  readonly power: number;
}

const LAMPS: readonly Lamp[] = [
  { at: [0, 0, 7.5], size: [7, 7, 0.2], power: 5 },
  { at: [-7, -5, 3], size: [0.2, 5, 5], power: 3.2 },
  { at: [7, -3, 2], size: [0.2, 4, 6], power: 1.6 },
  { at: [0, 8, 3], size: [8, 0.2, 4], power: 1.3 },
];

/**
 * Pixels along an edge of the cube that is blurred. Bricks are too rough to mirror more, and each pixel takes
 * hundreds of samples: at the usual 256, a processor that draws in software spends a second on it at the start.
 */
const ROOM_PIXELS = 64;

/**
 * The light that comes from all round: a pale room with four soft lamps, blurred for reflections.
 * Made by the program, so that no picture has to be loaded.
 */
export function studioEnvironment(renderer: WebGLRenderer): Texture {
  const room = new Scene();
  const box = new BoxGeometry(1, 1, 1);
  const walls = new MeshBasicMaterial({ color: new Color(0.62, 0.64, 0.68), side: BackSide });
  const shell = new Mesh(box, walls);
  shell.scale.set(20, 20, 16);
  room.add(shell);
  const floor = new Mesh(box, new MeshBasicMaterial({ color: new Color(0.5, 0.5, 0.5) }));
  floor.scale.set(20, 20, 0.2);
  floor.position.z = -6;
  room.add(floor);
  const materials = [walls, floor.material];
  for (const lamp of LAMPS) {
    const glow = new MeshBasicMaterial({ color: new Color().setScalar(lamp.power) });
    const board = new Mesh(box, glow);
    board.position.set(...lamp.at);
    board.scale.set(...lamp.size);
    room.add(board);
    materials.push(glow);
  }
  const generator = new PMREMGenerator(renderer);
  const target = generator.fromScene(room, 0.04, 0.1, 100, { size: ROOM_PIXELS });
  generator.dispose();
  box.dispose();
  for (const material of materials) {
    material.dispose();
  }
  return target.texture;
}
