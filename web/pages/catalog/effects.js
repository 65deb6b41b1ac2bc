// SPDX-License-Identifier: MIT
/**
 * @file The catalog page's side effects: the address, and files to save. They follow from the states before and after
 * an action.
 */
import { formatCatalogAddress } from '../../address/catalog.js';
import { catalogCsv } from './csv.js';
import { findEntry } from './select.js';

/** @import {Report} from '../../../wasm/types.js' */
/** @import {MakeSurface} from '../../worker/surfaces.js' */
/** @import {Action, Download, EntryId, State} from './types.js' */

/** What each download contains, and the ending and type of its file. @type {Record<Download, {what: Parameters<MakeSurface>[0]['what'], ending: string, type: string}>} */
const downloads = {
  cage: { what: 'cage', ending: '.cage.obj', type: 'model/obj' },
  control: { what: 'control', ending: '.control.obj', type: 'model/obj' },
  limit: { what: 'limit', ending: '.limit.obj', type: 'model/obj' },
  stl: { what: 'stl', ending: '.stl', type: 'model/stl' },
  glb: { what: 'glb', ending: '.glb', type: 'model/gltf-binary' },
};

/**
 * @param {object} surroundings
 * @param {(action: Action) => void} surroundings.dispatch
 * @param {MakeSurface} surroundings.makeSurface
 * @param {(name: string) => Promise<Report>} surroundings.loadReport
 * @param {(name: string, content: string | ArrayBuffer, type: string) => void} surroundings.save
 * @param {(search: string, how: 'push' | 'replace') => void} surroundings.setAddress from the question mark on
 * @returns {(action: Action, before: State, after: State) => void}
 */
export function createEffects({ dispatch, makeSurface, loadReport, save, setAddress }) {
  /** @param {State} state @param {EntryId} id @param {Download} what */
  async function download(state, id, what) {
    const found = findEntry(state.catalog, id);
    if (!found) throw new Error(`there is no entry ${id}`);
    const { entry, shape } = found;
    const report = what !== 'cage' && entry.minimizer ? await loadReport(entry.minimizer) : null;
    const made = await makeSurface({ what: downloads[what].what, cage: shape.cage, report, name: id });
    if (typeof made !== 'string' && !(made instanceof ArrayBuffer)) throw new Error(`${what} is no file`);
    const { ending, type } = downloads[what];
    save(`${what === 'cage' ? shape.name : id}${ending}`, made, type);
  }

  return (action, before, after) => {
    if (action.type !== 'addressFollowed') {
      const search = formatCatalogAddress(after.address);
      const how = action.type === 'entryOpened' ? 'push' : 'replace';
      if (search !== formatCatalogAddress(before.address)) setAddress(search, how);
    }
    if (action.type === 'tablePressed' && after.catalog) {
      save('umbilic-catalog.csv', catalogCsv(after.catalog), 'text/csv;charset=utf-8');
    }
    if (after.exporting && after.exporting !== before.exporting) {
      download(after, after.exporting.entry, after.exporting.what).then(
        () => dispatch({ type: 'exported' }),
        (error) => dispatch({ type: 'exportFailed', message: error instanceof Error ? error.message : String(error) }),
      );
    }
  };
}
