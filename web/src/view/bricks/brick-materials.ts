import {
  DoubleSide,
  FrontSide,
  type Material,
  MeshStandardMaterial,
  type Plane,
  ShaderMaterial,
} from 'three';

/**
 * Lines of many bricks in one draw call. A line whose two face normals are given is drawn only where
 * one face looks towards the eye and the other away: the outline of round surfaces.
 */
const LINE_VERTEX = /* glsl */ `
attribute vec3 normal1;
attribute vec3 normal2;
attribute mat4 brickMatrix;
attribute vec3 brickColour;
varying vec3 vColour;
#include <clipping_planes_pars_vertex>

bool facesEye(vec3 normal, vec3 toEye) {
  return dot(normalMatrix * mat3(brickMatrix) * normal, toEye) > 0.0;
}

void main() {
  vColour = brickColour;
  vec4 mvPosition = modelViewMatrix * brickMatrix * vec4(position, 1.0);
  vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -mvPosition.xyz;
  bool smoothSurface = dot(normal1, normal1) > 0.5;
  // Pulled a little towards the eye, so that lines win against the surfaces that they lie on.
  if (isOrthographic) {
    mvPosition.z += 0.012;
  } else {
    mvPosition.xyz *= 0.99975;
  }
  gl_Position = projectionMatrix * mvPosition;
  if (smoothSurface && facesEye(normal1, toEye) == facesEye(normal2, toEye)) {
    gl_Position = vec4(2.0, 2.0, 2.0, 0.0);
  }
  #include <clipping_planes_vertex>
}
`;

const LINE_FRAGMENT = /* glsl */ `
uniform float opacity;
varying vec3 vColour;
#include <clipping_planes_pars_fragment>

void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = vec4(vColour, opacity);
  #include <colorspace_fragment>
}
`;

/** Edges of ghosts, as a share of the others' opacity. */
const GHOST_LINES = 0.2;

/** The four materials that all bricks share. */
export class BrickMaterials {
  readonly surface = new MeshStandardMaterial({
    vertexColors: true,
    roughness: 0.36,
    metalness: 0,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  readonly ghost = new MeshStandardMaterial({
    vertexColors: true,
    roughness: 0.8,
    transparent: true,
    opacity: 0.1,
    depthWrite: false,
  });
  readonly lines = lineMaterial();
  readonly ghostLines = lineMaterial();

  /** @param opacity of the drawn edges, 0 to 1. */
  setLineOpacity(opacity: number): void {
    this.lines.uniforms['opacity'] = { value: opacity };
    this.ghostLines.uniforms['opacity'] = { value: opacity * GHOST_LINES };
  }

  /** Cuts everything on the far side of the plane away; null shows all. */
  setSection(plane: Plane | null): void {
    for (const material of this.#all()) {
      material.clippingPlanes = plane ? [plane] : null;
      material.clipShadows = true;
      material.needsUpdate = true;
    }
    this.surface.side = plane ? DoubleSide : FrontSide;
  }

  dispose(): void {
    for (const material of this.#all()) {
      material.dispose();
    }
  }

  #all(): Material[] {
    return [this.surface, this.ghost, this.lines, this.ghostLines];
  }
}

function lineMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: LINE_VERTEX,
    fragmentShader: LINE_FRAGMENT,
    uniforms: { opacity: { value: 1 } },
    transparent: true,
    depthWrite: false,
    clipping: true,
  });
}
