declare module 'gltf-validator' {
  /** What Khronos' validator says of a .gltf or .glb file; only what the tests read of it. */
  export interface Validation {
    readonly issues: { readonly numErrors: number; readonly numWarnings: number };
    readonly info: {
      readonly version: string;
      readonly materialCount: number;
      readonly totalTriangleCount: number;
    };
  }

  export function validateBytes(file: Uint8Array): Promise<Validation>;
}
