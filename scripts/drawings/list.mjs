import * as buildings from './buildings.mjs';
import * as creatures from './creatures.mjs';
import * as machines from './machines.mjs';
import * as things from './things.mjs';
import * as vehicles from './vehicles.mjs';

/** Every drawing that a program makes, by the name of its file. */
export const DRAWINGS = {
  house: buildings.house,
  castle: buildings.castle,
  'tower-2d': buildings.flatTower,
  'tower-3d': buildings.tower,
  'truss-bridge': buildings.trussBridge,
  windmill: buildings.windmill,
  'marble-run': buildings.marbleRun,
  airplane: vehicles.airplane,
  'race-car': vehicles.raceCar,
  satellite: vehicles.satellite,
  'space-station': vehicles.spaceStation,
  'roller-coaster': vehicles.rollerCoaster,
  crane: machines.crane,
  excavator: machines.excavator,
  'print-box': machines.printer,
  plotter: machines.plotter,
  dinosaur: creatures.dinosaur,
  robot: creatures.robot,
  'walking-robot': creatures.walkingRobot,
  helix: creatures.helix,
  crossbow: things.crossbow,
  'long-bow': things.longBow,
  bicycle: things.bicycle,
  'chair-front': things.chair,
  bridge: things.suspensionBridge,
  cube: things.cube,
};
