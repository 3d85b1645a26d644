import type { ComponentType } from 'preact';

/** What a room is given. */
export interface RoomProps {
  /** Goes back to the drawing. */
  readonly close: () => void;
}

/** A full page beside the drawing, such as the instructions: `?room=ID` in the address opens it. */
export interface Room {
  /** Lower-case letters and hyphens. */
  readonly id: string;
  readonly title: string;
  /** Loads the room's own code when it is first opened. */
  readonly load: () => Promise<ComponentType<RoomProps>>;
}
