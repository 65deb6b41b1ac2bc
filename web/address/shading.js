// SPDX-License-Identifier: MIT
/**
 * @file The address field for the quantity that colours a surface.
 */
import { allQuantities, quantities } from '../colour/quantities.js';
import { choice } from './fields.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Field} from './fields.js' */

/** @type {Field<Shading>} */
export const shadingField = choice([...quantities.map(({ shading }) => shading), 'stripes', 'plain'], 'mean');

/** Of the studio, whose surface has one that it began with. @type {Field<Shading>} */
export const studioShadingField = choice([...allQuantities.map(({ shading }) => shading), 'stripes', 'plain'], 'mean');
