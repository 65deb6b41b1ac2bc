// SPDX-License-Identifier: MIT
/**
 * @file The types of the page's one state object and of the actions that change it; nothing here runs.
 */

/** @import {CageCounts, CapName, CertificateReport, Energies, FunctionalName} from '../../wasm/types.js' */
/** @import {Group, LevelReport, Limit, Mesh, Progress, StopReason} from '../../wasm/types.js' */
/** @import {Shading} from '../colour/quantities.js' */
/** @import {Message, Source} from '../worker/protocol.js' */
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
 * @property {number} maxIterations per level
 * @property {'cage' | 'surface'} origin where the next run starts from, once there is a surface to go on from
 */

/** The generator as chosen. @typedef {{name: string, family: 'hub' | 'flag', thickness: number}} Generator */

/** The cage that is open. @typedef {{source: Source, name: string, counts: CageCounts}} OpenCage */

/**
 * A cage or a surface that the worker is opening under a new run number.
 * @typedef {object} Opening
 * @property {number} run
 * @property {Source} source
 * @property {Settings} settings as they were when it began
 * @property {'cage' | 'preview' | 'start' | 'recovery'} purpose a new cage; the same with other settings; a new run;
 *   back after the worker was lost
 * @property {'hold' | 'run' | 'step'} then
 * @property {number} levelOffset levels of the run start here, counted from the cage
 */

/**
 * One point of the plot.
 * @typedef {{evaluation: number, energy: number, gradientNorm: number, level: number}} Sample
 */

/** @typedef {{energies: Energies, evaluations: number}} Measurement */

/** The surface on the screen. @typedef {{limit: Mesh, control: Mesh, evaluations: number}} Surface */

/**
 * The control mesh in safe keeping; `level` counts from the cage.
 * @typedef {{obj: string, level: number, evaluations: number}} SavedControl
 */

/**
 * A certificate that the worker is making: how much of it is done, and whether it was asked to abandon it.
 * @typedef {{progress: number, abandoning: boolean}} Certifying
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
 * @property {Generator} generator
 * @property {Settings} settings
 * @property {OpenCage | null} cage
 * @property {Opening | null} opening
 * @property {number} lastRun the largest run number given out
 * @property {number} run whose messages count
 * @property {Settings} runSettings of the run on the screen
 * @property {Group | null} group the symmetry that it keeps
 * @property {number} levelOffset
 * @property {'pause' | 'cancel' | null} asked and not answered yet
 * @property {Progress | null} progress
 * @property {StopReason | 'interrupted' | null} stop
 * @property {Sample[]} samples
 * @property {LevelReport[]} levels their `level` counts from the cage
 * @property {Limit | null} limit of the levels so far
 * @property {Measurement | null} first measurement of this run
 * @property {Measurement | null} latest
 * @property {Surface | null} surface
 * @property {SavedControl | null} saved
 * @property {number} fits how often the view was asked to fit the surface
 * @property {boolean} fitDue the next surface is a new cage's
 * @property {boolean} exporting
 * @property {Certifying | null} certifying
 * @property {CertificateReport | null} certificate of the surface on the screen; its `level` counts from the cage
 * @property {Alert | null} alert
 * @property {{shading: Shading, cage: boolean, theme: 'light' | 'dark' | 'system'}} view
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
 *   | {type: 'viewChanged', change: Partial<State['view']>}
 *   | {type: 'fitPressed'}
 *   | {type: 'downloadPressed', what: 'control' | 'limit' | 'report'}
 *   | {type: 'alertDismissed'}
 *   | {type: 'answered', message: Message}
 *   | {type: 'workerLost', loss: Loss, detail: string}} Action
 */

export {};
