/** What ADMesh would have to mend in an STL file: the rows of its table that are not 0. */
export function mendsOf(path: string): string[];
