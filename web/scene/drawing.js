// SPDX-License-Identifier: MIT
/**
 * @file Whether the browser draws with graphics hardware, slowly without it, or not at all.
 */

/** Names of drivers without hardware. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** @returns {'fast' | 'slow' | 'never'} */
export function drawing() {
  try {
    const context = document.createElement('canvas').getContext('webgl2');
    if (!context) return 'never';
    const names = context.getExtension('WEBGL_debug_renderer_info');
    const name = names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
    context.getExtension('WEBGL_lose_context')?.loseContext();
    return SOFTWARE.test(name) ? 'slow' : 'fast';
  } catch {
    return 'never';
  }
}
