// SPDX-License-Identifier: MIT
/**
 * @file The address field for the quantity that colours a surface.
 */
import { allQuantities, quantities, shadingsOf } from '../colour/quantities.js';
import { choice } from './fields.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Field} from './fields.js' */

/** @type {Field<Shading>} */
export const shadingField = choice(shadingsOf(quantities), 'mean');

/** Of the studio, whose surface has one that it began with. @type {Field<Shading>} */
export const studioShadingField = choice(shadingsOf(allQuantities), 'mean');
