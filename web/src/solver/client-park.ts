import type { SolverClient } from './worker-client.ts';

interface Place {
  readonly client: SolverClient;
  /** What was asked of it and is not answered. */
  open: number;
}

/**
 * Several workers, each started when it is first needed. A worker that is busy with a question answers
 * nothing else for as long as that takes, so whoever asks is given one that is free.
 */
export class ClientPark {
  readonly #create: () => SolverClient;
  readonly #most: number;
  readonly #places: Place[] = [];

  /** @param most workers that are started at most; past that the one with the least to do is given. */
  constructor(create: () => SolverClient, most: number) {
    this.#create = create;
    this.#most = most;
  }

  /** A client whose worker has nothing to do, as long as there may be one. */
  free(): SolverClient {
    const idle = this.#places.find(({ open }) => open === 0);
    return this.#counted(idle ?? this.#another() ?? this.#leastBusy());
  }

  dispose(): void {
    for (const { client } of this.#places) {
      client.dispose();
    }
  }

  #another(): Place | null {
    if (this.#places.length >= this.#most) {
      return null;
    }
    const place = { client: this.#create(), open: 0 };
    this.#places.push(place);
    return place;
  }

  #leastBusy(): Place {
    const [first, ...others] = this.#places;
    if (first === undefined) {
      throw new RangeError('a park of workers has room for one at least');
    }
    return others.reduce((least, place) => (place.open < least.open ? place : least), first);
  }

  #counted(place: Place): SolverClient {
    const { client } = place;
    const count = <T>(answer: Promise<T>): Promise<T> => {
      place.open += 1;
      return answer.finally(() => {
        place.open -= 1;
      });
    };
    return {
      solve: (...asked) => count(client.solve(...asked)),
      check: (...asked) => count(client.check(...asked)),
      exportModel: (...asked) => count(client.exportModel(...asked)),
      ask: (...asked) => count(client.ask(...asked)),
      warmUp: () => client.warmUp(),
      dispose: () => client.dispose(),
    };
  }
}
