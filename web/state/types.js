// SPDX-License-Identifier: MIT
/**
 * @file The types of the page's one state object and of the actions that change it; nothing here runs.
 */

/** @import {CageReport, CapName, CertificateReport, Energies, FunctionalName} from '../../wasm/types.js' */
/** @import {GeneratedCage, Group, LevelReport, Limit, Mesh, Progress, Report, StopReason, SurfaceState} from '../../wasm/types.js' */
/** @import {Camera} from '../address/camera.js' */
/** @import {EntryName} from '../address/compare.js' */
/** @import {Shading} from '../colour/quantities.js' */
/** @import {CatalogEntry} from '../files/catalog.js' */
/** @import {Exportable, Message} from '../worker/protocol.js' */
/** @import {Loss} from '../worker/client.js' */

/**
 * What the user asks for. `functional` 'blend' means the weights.
 * @typedef {object} Settings
 * @property {FunctionalName | 'blend'} functional
 * @property {Record<FunctionalName, number>} weights
 * @property {CapName} cap
 * @property {boolean} symmetry whether the surface keeps the cage's
 * @property {[number, number]} levels Catmull-Clark steps from the cage
 * @property {number} tolerance
 * @property {number} max_iterations per level
 * @property {'cage' | 'surface'} origin where the next run starts from, once there is a surface to go on from
 */

/**
 * Where a cage comes from: a generator's name and parameters; the text of an OBJ or OFF file; or the file of a problem or
 * a report, as long as nobody has read it.
 * @typedef {{name: string, family: 'hub' | 'flag', thickness: number}} Generator
 * @typedef {{kind: 'generated'} & Generator & Omit<GeneratedCage, 'generator'>} Generated
 * @typedef {{kind: 'text', name: string, text: string | Uint8Array}} FileText
 * @typedef {Generated | FileText | {kind: 'problem', name: string, text: Uint8Array}} Source
 */

/** The cage that is open. @typedef {{source: Generated | FileText, name: string, counts: CageReport}} OpenCage */

/**
 * A cage or a surface that the worker is opening under a new run number.
 * @typedef {object} Opening
 * @property {number} run
 * @property {Source} source
 * @property {Settings} settings as they were when it began
 * @property {'cage' | 'preview' | 'start' | 'recovery' | 'entry'} purpose a new cage; the same with other settings; a new run;
 *   back after the worker was lost; a minimizer of the catalog
 * @property {'hold' | 'run' | 'step'} then
 * @property {SurfaceState | null} start where the run goes on, instead of beginning with the cage
 * @property {CatalogEntry} [entry] that is opened
 * @property {Report} [report] its
 */

/**
 * One point of the plot.
 * @typedef {{evaluation: number, energy: number, gradientNorm: number, level: number}} Sample
 */

/** @typedef {{energies: Energies, evaluations: number}} Measurement */

/** The surface on the screen. @typedef {{limit: Mesh, control: Mesh, evaluations: number}} Surface */

/** The surface in safe keeping. @typedef {{state: SurfaceState, evaluations: number}} SavedSurface */

/**
 * A certificate that the worker is making: how much of it is done, and whether it was asked to abandon it.
 * @typedef {{progress: number, abandoning: boolean}} Certifying
 */

/** What a run has ended in. @typedef {Pick<Report, 'levels' | 'limit' | 'energies' | 'certificate'>} Outcome */

/**
 * A minimizer of the catalog: what a run of these settings ends in, and the number under which it was opened.
 * @typedef {{entry: CatalogEntry, settings: Settings, run: number}} OpenEntry
 */

/** @typedef {{title: string, message: string}} Alert */

/**
 * `loading`: the core is not there yet. `resting`: the cage's own surface. `paused` and `ended`: a run's.
 * @typedef {'loading' | 'resting' | 'running' | 'paused' | 'ended' | 'unavailable'} Status
 */

/**
 * @typedef {object} State
 * @property {Status} status
 * @property {string} version of the core
 * @property {string[]} cageNames
 * @property {Generator} generator as chosen
 * @property {Settings} settings
 * @property {OpenCage | null} cage
 * @property {EntryName | null} wanted an entry of the catalog that is being loaded
 * @property {OpenEntry | null} minimizer of the catalog, the last that was opened on this cage
 * @property {Opening | null} opening
 * @property {number} lastRun the largest run number given out
 * @property {number} run whose messages count
 * @property {Settings} runSettings of the run on the screen
 * @property {Group | null} group the symmetry that it keeps
 * @property {'pause' | 'cancel' | null} asked and not answered yet
 * @property {Progress | null} progress
 * @property {StopReason | 'interrupted' | null} stop
 * @property {Sample[]} samples
 * @property {LevelReport[]} levels
 * @property {Limit | null} limit of the levels so far
 * @property {Measurement | null} first measurement of this run
 * @property {Measurement | null} latest
 * @property {Surface | null} surface
 * @property {boolean} coarse whether more of it is to be asked for when it has been drawn
 * @property {SavedSurface | null} saved
 * @property {number} fits how often the view was asked to fit the surface
 * @property {boolean} fitDue the next surface is a new cage's
 * @property {boolean} exporting
 * @property {Certifying | null} certifying
 * @property {CertificateReport | null} certificate of the surface on the screen
 * @property {Alert | null} alert
 * @property {{shading: Shading, cage: boolean, camera: Camera, theme: 'light' | 'dark' | 'system'}} view
 */

/**
 * @typedef {{type: 'generatorChanged', change: Partial<Generator>}
 *   | {type: 'fileChosen', name: string, text: Uint8Array}
 *   | {type: 'fileRefused', name: string, message: string}
 *   | {type: 'settingsChanged', change: Partial<Settings>}
 *   | {type: 'weightChanged', functional: FunctionalName, weight: number}
 *   | {type: 'startPressed'} | {type: 'pausePressed'} | {type: 'stepPressed'} | {type: 'cancelPressed'} | {type:
 * 'resetPressed'}
 *   | {type: 'certifyPressed'} | {type: 'certificateCancelPressed'}
 *   | {type: 'entryLoaded', name: EntryName, entry: CatalogEntry, report: Report}
 *   | {type: 'entryMissing', name: EntryName, message: string}
 *   | {type: 'againPressed'}
 *   | {type: 'viewChanged', change: Partial<State['view']>}
 *   | {type: 'fitPressed'}
 *   | {type: 'surfaceDrawn'}
 *   | {type: 'downloadPressed', what: Exportable}
 *   | {type: 'alertDismissed'}
 *   | {type: 'answered', message: Message}
 *   | {type: 'workerLost', loss: Loss, detail: string}} Action
 */

export {};
