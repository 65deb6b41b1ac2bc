// SPDX-License-Identifier: MIT
/**
 * @file The types of the studio's state and actions; no code.
 */

/** @import {BoundaryCondition, CageReport, CapName, CertificateReport, Constraints, ConstraintsReport, Energies, Estimate} from '../../../../wasm/types.js' */
/** @import {FaceGroup, Fill, FunctionalName} from '../../../../wasm/types.js' */
/** @import {GeneratedCage, Group, LevelReport, Limit, Mesh, Progress, Report, StopReason, SurfaceState, Targets} from '../../../../wasm/types.js' */
/** @import {AxisView, Camera, Projection} from '../../../address/camera.js' */
/** @import {EntryName} from '../../../address/compare.js' */
/** @import {Shading} from '../../../colour/quantities.js' */
/** @import {Point, PolygonCage, Selection} from '../../../cage/polygons.js' */
/** @import {CatalogEntry} from '../../../files/catalog.js' */
/** @import {ComputedValues} from '../../../worker/computed.js' */
/** @import {Crossings} from '../../../worker/crossings.js' */
/** @import {Section} from './section.js' */
/** @import {Exportable, ExportOptions, Message} from '../../../worker/protocol.js' */
/** @import {Loss} from '../../../worker/client.js' */

/** Three different functionals, at the top, the left and the right. @typedef {[FunctionalName, FunctionalName, FunctionalName]} Corners */

/**
 * The user's settings. With `functional` 'blend' the weights hold.
 * @typedef {object} Settings
 * @property {FunctionalName | 'blend'} functional
 * @property {Record<FunctionalName, number>} weights
 * @property {Corners} corners of the triangle in which the weights are chosen; nothing that is minimized depends on them
 * @property {CapName} cap
 * @property {1|2|4|8|16} cap_rings the most rings of faces that a smooth cap takes
 * @property {boolean} symmetry whether the surface keeps the symmetry of the cage
 * @property {[number, number]} levels Catmull-Clark steps from the cage
 * @property {number | null} accuracy the part of the limit within which it is to be known, by as many levels as that takes
 * @property {number} tolerance
 * @property {number} max_iterations per level
 * @property {Constraints} constraints what is held, of the cage that is open; without lists that are empty
 * @property {Fill | null} fill the boundaries of this cage that are closed with faces
 * @property {'cage' | 'surface'} origin where the next run starts, once there is a surface
 */

/**
 * The source of a cage: a generator's name and parameters; the text of an OBJ, OFF or PLY file; or the file of a problem or
 * a report that has not been parsed yet.
 * @typedef {{name: string, family: 'hub' | 'flag', thickness: number}} Generator
 * @typedef {{kind: 'generated'} & Generator & Omit<GeneratedCage, 'generator'>} Generated
 * @typedef {{kind: 'text', name: string, text: string | Uint8Array}} FileText
 * @typedef {Generated | FileText | {kind: 'problem', name: string, text: Uint8Array}} Source
 */

/**
 * The cage that is open. `groups` are those of its file.
 * @typedef {{source: Generated | FileText, name: string, counts: CageReport, groups: FaceGroup[]}} OpenCage
 */

/**
 * Faces that are held or free. `fileFaces` has for each face the one of the file's cage, from 0, or -1 (see taken.js);
 * without, they are the same. `free` are the groups that alone are free unless the constraints say what is held.
 * @typedef {Pick<OpenCage, 'counts' | 'groups'> & {fileFaces?: Int32Array, free?: string[]}} CageFaces
 *
 * The cage as the run on the screen takes it, with boundaries filled. `fills` has the group of the new faces of
 * each.
 * @typedef {Required<CageFaces> & {fills: Array<{boundary: number, group: string}>}} TakenCage
 *
 * What the core refused, and the place on the page where that is said; `boundary` is its number, or null.
 * @typedef {{place: 'boundary' | 'fill' | 'closeness', boundary: number | null, message: string}} Refusal
 */

/**
 * What the pointer does on the surface: turns it, holds faces, frees them, or pins vertices; or on the cage, selects parts of
 * it. @typedef {'turn' | 'hold' | 'free' | 'pin' | 'edit'} Pointer
 */

/**
 * An edit of what is selected of the cage. `by` is a vector, or a distance.
 * @typedef {{kind: 'move', by: Point} | {kind: 'extrude', by: number} | {kind: 'remove'} | {kind: 'bridge'} | {kind: 'split'}
 *   | {kind: 'mirror', axis: 0 | 1 | 2, side: 1 | -1}} CageEdit
 *
 * The cage that can be edited: that of a source, what of it is selected, and how far a hand has moved that which still
 * holds it. `said` is why the last edit was refused, or what was lost by it.
 * @typedef {{source: OpenCage['source'], cage: PolygonCage, selection: Selection, drag: Point | null, said: string}} Editing
 *
 * What an edit leaves behind, once the core has opened its cage. `kept` is what is held then.
 * @typedef {{cage: PolygonCage, selection: Selection, kept: Pick<Settings, 'constraints' | 'fill'>, said: string}} EditedCage
 */

/**
 * A cage or a surface that the worker is opening under a new run number.
 * @typedef {object} Opening
 * @property {number} run
 * @property {Source} source
 * @property {Settings} settings the settings when opening began
 * @property {'cage' | 'preview' | 'start' | 'recovery' | 'entry'} purpose a new cage; the same cage with other
 *   settings; a new run; the surface again after the worker was lost; a minimizer of the catalog
 * @property {'hold' | 'run' | 'step'} then
 * @property {SurfaceState | null} start the surface from which the run starts; null for the cage's
 * @property {{name: string, asked: Asked}} [before] the step of the history that this makes once it has opened, and what was
 *   asked before
 * @property {EditedCage} [edited] of a new cage that an edit has made
 * @property {CatalogEntry} [entry] the catalog entry that is opened
 * @property {Report} [report] the report of this entry
 */

/**
 * One point of the plot.
 * @typedef {{evaluation: number, energy: number, gradientNorm: number, level: number}} Sample
 */

/** Energies of a surface of this level. @typedef {{energies: Energies, evaluations: number, level: number}} Measurement */

/**
 * The surface on the screen. `density` counts the quads along each edge of a patch of its limit mesh, and `patches` has its
 * evaluated mesh. `computed` has a value of each vertex of the limit mesh, if the shading needs one; see worker/computed.js.
 * `crossings` are those of the limit mesh, once they are known.
 * @typedef {{limit: Mesh, density: number, control: Mesh, patches: number, computed: ComputedValues | null, crossings: Crossings | null,
 *   evaluations: number}} Surface
 */

/** Where a run began: the limit mesh of the cage's own surface, and the cage. @typedef {{run: number, limit: Mesh, density: number, cage: Mesh}} Start */

/** A copy of the surface, in case the worker is lost. @typedef {{state: SurfaceState, evaluations: number}} SavedSurface */

/**
 * A certificate that the worker is computing: its progress, and whether the page asked to abandon it.
 * @typedef {{progress: number, abandoning: boolean}} Certifying
 */

/** The result of a run. @typedef {Pick<Report, 'levels' | 'limit' | 'energies' | 'certificate' | 'constraints'>} Outcome */

/**
 * A minimizer of the catalog: its entry, and the settings of its run.
 * @typedef {{entry: CatalogEntry, settings: Settings}} OpenEntry
 */

/**
 * `retry` is what can be tried again: to load the core, or an entry of the catalog. `save`: whether to offer to save the project.
 * @typedef {{title: string, message: string, retry?: 'core' | EntryName, save?: boolean}} Alert
 */

/**
 * What came out of a problem: the run on the screen.
 * @typedef {object} Result
 * @property {Settings} settings of the run
 * @property {Group | null} group the symmetry that it keeps
 * @property {TakenCage | null} taken the cage as it takes it; null if that is the file's
 * @property {number[] | null} held the numbers of the faces that it holds, from 1, where it copies constraints over the symmetry
 * @property {boolean} catalogs whether it is the catalog's, opened as the end of a run
 * @property {Progress | null} progress
 * @property {StopReason | 'interrupted' | null} stop
 * @property {Sample[]} samples
 * @property {LevelReport[]} levels
 * @property {Limit | null} limit the limit of the levels so far
 * @property {Measurement | null} first the first measurement
 * @property {Measurement | null} latest
 * @property {SavedSurface | null} saved
 * @property {SurfaceState | null} [start] the surface from which its run began, if not from the cage's; missing in what an
 *   earlier version kept
 * @property {CertificateReport | null} certificate of its surface
 * @property {ConstraintsReport | null} constrained what the constraints do to its surface, once it has moved
 */

/**
 * What is saved: the problem, and what came out of it. Plain data, without the meshes, which the worker makes anew.
 * @typedef {object} Document
 * @property {Generator} generator the chosen shape
 * @property {Settings} settings of the next run
 * @property {OpenCage | null} cage null until the first one has opened
 * @property {OpenEntry | null} minimizer the last catalog entry that was opened on this cage
 * @property {Result} result
 */

/**
 * What the worker does. `loading`: the core is being loaded. `resting`: shows the surface of the cage. `paused` and
 * `ended`: shows that of a run. `asked` is a command that the worker has not answered yet, and `certifying` the certificate
 * that it computes.
 * @typedef {{name: 'loading'} | {name: 'resting'} | {name: 'running', asked: 'pause' | 'cancel' | null}
 *   | {name: 'paused', asked: 'cancel' | null} | {name: 'ended', certifying: Certifying | null}
 *   | {name: 'unavailable'}} Phase
 */

/**
 * What runs: the worker, and what is to be opened in it.
 * @typedef {object} Session
 * @property {Phase} phase
 * @property {number} run the run on the screen; messages about others are ignored
 * @property {number} lastRun the largest run number so far
 * @property {number | null} before the evaluations that the surface had when it was brought back, which this run does not
 *   count; null if the run began anew
 * @property {Opening | null} opening beside whatever the phase is
 * @property {EntryName | null} wanted a catalog entry that is being loaded
 * @property {Targets | null} targets what the run was last told to follow
 * @property {boolean} exporting
 * @property {Estimate | null} estimate what the run on the screen was expected to take when it opened
 * @property {Refusal | null} refused
 * @property {string} version version of the core
 * @property {string[]} cageNames
 */

/**
 * What is looked at, and what is said.
 * @typedef {object} View
 * @property {Shading} shading
 * @property {boolean} cage whether the control cage is shown
 * @property {boolean} original whether the cage is shown that the surface began from
 * @property {boolean} patches whether the edges of the patches are shown
 * @property {{shading: Shading, low: number, high: number} | null} pinned the range of the colours of one shading, if it is to stay
 * @property {boolean} crossings whether the curves are shown in which the surface crosses itself
 * @property {Section} section the plane that cuts the surface
 * @property {boolean} printing whether a file for printing is about to be saved
 * @property {boolean} isolines whether the quantity that colours the surface has isolines
 * @property {Camera} camera
 * @property {Camera | null} returnTo the camera before it looked along an axis; null once it was turned otherwise
 * @property {Projection} projection
 * @property {'light' | 'dark' | 'system'} theme
 * @property {Pointer} pointer
 * @property {Editing | null} editing null until the worker has told the cage
 * @property {number | null} boundary the number of the one that is marked on the surface
 * @property {number | null} pin the one that has the handle, from 0
 * @property {Surface | null} surface
 * @property {boolean} before whether the cage's own surface is shown in the place of the surface
 * @property {Start | null} start of the run that was asked last
 * @property {boolean} coarse whether to ask for a finer surface once this one has been drawn
 * @property {number} fits how often the user asked to fit the surface into the view
 * @property {boolean} fitDue whether the next surface belongs to a new cage
 * @property {string} said a sentence about the last change of what is held, if it changed nothing
 * @property {Alert | null} alert
 */

/** What is asked of a run. @typedef {Pick<Document, 'generator' | 'settings'>} Asked */

/**
 * A step of the history, with what is on its other side: only what is asked, or the whole document with the phase in which
 * it was. `stroke`: the brush is still down, or the slider of a weight or a part of the cage still held.
 * @typedef {{name: string, stroke?: boolean} & ({asked: Asked} | {document: Document, phase: Phase['name']})} Step
 *
 * The steps that can be undone, and those that can be redone, the next one last.
 * @typedef {{past: Step[], future: Step[]}} History
 */

/** @typedef {{document: Document, session: Session, view: View, history: History}} State */

/**
 * What can be saved as a file: what the worker makes, a picture of the view, and the history of the run. Pictures have a size
 * in pixels, and the page's background or none.
 * @typedef {Exportable | 'picture' | 'history'} Download
 * @typedef {ExportOptions & {size?: [number, number], background?: boolean}} DownloadOptions
 */

/** How near the surface stays to the cage's own. @typedef {NonNullable<Constraints['closeness']>} Closeness */

/**
 * Changes of what is held. `boundary` is a number from 1, or null for all. Faces are numbered from 0, as in meshes, vertices from 1. A stroke of the brush is many
 * `facesPainted` and an end. `moving`: the hand still moves.
 * @typedef {{type: 'facesPainted', faces: number[], held: boolean}
 *   | {type: 'paintingEnded'}
 *   | {type: 'groupHeld', name: string, held: boolean}
 *   | {type: 'holdEdited', how: 'all' | 'invert' | 'grow' | 'clear'}
 *   | {type: 'vertexPinned', vertex: number}
 *   | {type: 'pinRemoved', index: number}
 *   | {type: 'copiesSwitched', on: boolean}
 *   | {type: 'pinMoved', index: number, at: [number, number, number], moving?: boolean}
 *   | {type: 'pinTurned', index: number, normal: boolean | [number, number, number], moving?: boolean}
 *   | {type: 'conditionChosen', boundary: number | null, condition: BoundaryCondition}
 *   | {type: 'fillPressed', boundary: number | null, filled: boolean}
 *   | {type: 'closenessChanged', closeness: Closeness | null}} HoldAction
 */

/**
 * What is selected of the cage, and edits of that. `add`: beside what is selected already, or no more if it was.
 * @typedef {{type: 'cageSelected', selection: Selection}
 *   | {type: 'cagePicked', what: keyof Selection, numbers: number[], add: boolean}
 *   | {type: 'cageSelectionChanged', how: 'grow' | 'loop' | 'none'}
 *   | {type: 'cageDragged', by: Point}
 *   | {type: 'cageEdited', edit: CageEdit}} EditAction
 */

/**
 * `moving`: the hand still holds the slider.
 * @typedef {HoldAction | EditAction | {type: 'generatorChanged', change: Partial<Generator>}
 *   | {type: 'fileChosen', name: string, text: Uint8Array}
 *   | {type: 'fileRefused', name: string, message: string}
 *   | {type: 'settingsChanged', change: Partial<Settings>}
 *   | {type: 'weightsChanged', weights: Partial<Settings['weights']>, corners?: Corners, moving?: boolean}
 *   | {type: 'startPressed'} | {type: 'pausePressed'} | {type: 'stepPressed'} | {type: 'cancelPressed'} | {type:
 * 'resetPressed'}
 *   | {type: 'finerPressed'} | {type: 'goOnPressed'}
 *   | {type: 'certifyPressed'} | {type: 'descendPressed'} | {type: 'certificateCancelPressed'}
 *   | {type: 'entryLoaded', name: EntryName, entry: CatalogEntry, report: Report}
 *   | {type: 'entryMissing', name: EntryName, message: string, retry?: boolean}
 *   | {type: 'retryPressed'}
 *   | {type: 'againPressed'}
 *   | {type: 'viewChanged', change: Partial<View>}
 *   | {type: 'fitPressed'}
 *   | {type: 'axisPressed', axis: AxisView}
 *   | {type: 'surfaceDrawn'}
 *   | {type: 'downloadPressed', what: Download, options?: DownloadOptions}
 *   | {type: 'pictureTaken', failure: string | null}
 *   | {type: 'undoPressed'} | {type: 'redoPressed'}
 *   | {type: 'wakened'}
 *   | {type: 'linkRefused', message: string}
 *   | {type: 'documentParted'}
 *   | {type: 'alertDismissed'}
 *   | {type: 'answered', message: Message}
 *   | {type: 'workerLost', loss: Loss, detail: string}} Action
 */

export {};
