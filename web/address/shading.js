// SPDX-License-Identifier: MIT
/**
 * @file What a surface is shaded by, in an address.
 */
import { quantities } from '../colour/quantities.js';
import { choice } from './fields.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Field} from './fields.js' */

/** @type {Field<Shading>} */
export const shadingField = choice([...quantities.map(({ shading }) => shading), 'plain'], 'mean');
