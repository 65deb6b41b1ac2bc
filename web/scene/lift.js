// SPDX-License-Identifier: MIT
/**
 * @file Draws marks and lines a little nearer to the viewer than they are, so that they lie on the surface.
 */

/** By which part of their distance. */
export const LIFT = { line: 0.003, dot: 0.012 };

/**
 * Moves vertices towards the viewer, which leaves them where they are on the screen.
 * @param {{vertexShader: string}} shader
 * @param {number} part
 */
export function lift(shader, part) {
  const nearer = (1 - part).toFixed(4);
  shader.vertexShader = shader.vertexShader.replace(
    '#include <project_vertex>',
    `#include <project_vertex>
    vec3 lifted = isPerspectiveMatrix(projectionMatrix) ? mvPosition.xyz * ${nearer} : mvPosition.xyz * vec3(1.0, 1.0, ${nearer});
    gl_Position = projectionMatrix * vec4(lifted, 1.0);`,
  );
}
