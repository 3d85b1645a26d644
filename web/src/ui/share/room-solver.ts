import { createSolverClient } from '../../solver/client.ts';
import type { SolverClient } from '../../solver/worker-client.ts';

let client: SolverClient | null = null;

/** The solver of the rooms: one worker beside the drawing's, made when a room first needs it. */
export function roomSolver(): SolverClient {
  client ??= createSolverClient();
  return client;
}
