// SPDX-License-Identifier: MIT
/**
 * @file Help, version, and command lines that make no sense.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { functionals, outputOf, root, scratchFolder, tetrahedron, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const commands = ['cage', 'info', 'evaluate', 'optimize', 'check-gradient', 'torus', 'catalog'];

describe('help', () => {
  test('names every command', () => {
    const help = outputOf(['--help']);
    for (const command of commands) expect(help).toMatch(new RegExp(`^  ${command} `, 'm'));
    expect(help).toContain('Exit codes: 0 ended with a result');
  });

  test.each(commands)('of %s tells its usage and goes to standard output', (command) => {
    for (const flag of ['--help', '-h']) {
      const { code, out, err } = umbilic([command, flag]);
      expect({ code, err }).toEqual({ code: 0, err: '' });
      expect(out).toContain(`Usage: umbilic ${command} [OPTIONS]`);
    }
  });

  test('of optimize gives each functional its formula and each option its default', () => {
    const help = outputOf(['optimize', '--help']);
    for (const name of functionals) {
      expect(help).toMatch(new RegExp(`^  ${name} +(A(\\^2)? \\* )?integral of`, 'm'));
    }
    for (const fact of ['[0..2]', '[1000]', '[1e-6]', '[smooth]', '[auto]']) expect(help).toContain(fact);
    for (const option of ['--no-symmetry', '--metric NAME', '--certify']) {
      expect(help).toMatch(new RegExp(`^ +${option} +\\S`, 'm'));
    }
  });

  const reference = readFileSync(path.join(root, 'core/cli/README.md'), 'utf8');
  test.each(commands)('of %s names no option that the reference of the command line leaves out', (command) => {
    const options = outputOf([command, '--help']).match(/(?<=^ +(-\w,)?)--[a-z-]+/gm) ?? [];
    expect(options).toContain('--help');
    expect(options.filter((option) => !new RegExp(`${option}(?![a-z-])`).test(reference))).toEqual([]);
  });

  test('--version is that of the package', () => {
    const { version } = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8'));
    expect(outputOf(['--version'])).toBe(`umbilic ${version}\n`);
  });
});

/** @type {[string, string][]} */
const senseless = [
  ['', 'umbilic: A command is required'],
  ['improve', 'umbilic: The following argument was not expected: improve'],
  ['--instruction-set sse9 info -', 'unknown instruction set "sse9"; known are portable, avx2, avx512'],
  ['info', 'CAGE is required'],
  ['info - --jsn', 'not expected: --jsn'],
  ['info - -', 'not expected: -'],
  ['cage', 'cage needs a NAME, or --list'],
  ['cage two-2', 'there is no cage called two-2; there are cube, torus, two-3'],
  ['cage two-3 --family fat', "'fat' is not hub or flag"],
  ['cage two-3 --thickness 0', 'thickness 0 is not between 0.01 and 2.25'],
  ['cage two-3 --thickness -1', 'thickness -1 is not between 0.01 and 2.25'],
  ['cage two-3 --thickness 1x', "'1x' is not a number"],
  ['cage two-3 --thickness nan', "'nan' is not a number"],
  ['cage two-3 --ratio 0.5', 'cage two-3 has no --ratio'],
  ['cage cube --thickness 1', 'cage cube has no --thickness'],
  ['cage cube-frame --spread 1', 'cage cube-frame has no --spread'],
  ['cage torus --family hub', 'cage torus has no --family'],
  ['cage torus --ratio 1', 'ratio 1 is not between 0 and 1'],
  ['cage torus --segments 8', "'8' is not MxN, two numbers of segments"],
  ['cage torus --segments 2x6', '2 segments are not 3 to 1000'],
  ['cage torus --segments 8x6x4', "'8x6x4' is not MxN, two numbers of segments"],
  ['evaluate - --cap round', "'round' is none of none, flat, smooth"],
  ['evaluate - --levels 0..1', "'0..1' is not an integer from 0 to 20"],
  ['evaluate - --levels -1', "'-1' is not an integer from 0 to 20"],
  ['optimize -', '--functional or --weights is required'],
  ['check-gradient -', '--functional or --weights is required'],
  ['optimize - --functional elastic', 'unknown functional'],
  ['optimize - --functional bending --weights mvs=1', 'excludes'],
  ['optimize - --weights bending', 'bending'],
  ['optimize - --weights bending=-1', 'bending=-1'],
  ['optimize - --weights bending=0', 'all weights are zero'],
  ['optimize - --functional bending --levels 2..1', "'2..1' is not A..B or A with 0 <= A <= B <= 20"],
  ['optimize - --functional bending --levels ..1', "'..1' is not A..B"],
  ['optimize - --functional bending --levels 0..', "'0..' is not A..B"],
  ['optimize - --functional bending --levels 99', "'99' is not A..B"],
  ['optimize - --functional bending --max-iterations -1', "'-1' is not an integer from 0"],
  ['optimize - --functional bending --max-iterations 1.5', "'1.5' is not an integer from 0"],
  ['optimize - --functional bending --tolerance -1e-6', "'-1e-6' is negative"],
  ['optimize - --functional bending --tolerance inf', "'inf' is not a number"],
  ['optimize - --functional bending --metric newtons', "'newtons' is none of auto, identity, sobolev, hessian, newton"],
  ['optimize - --functional bending --metric', 'metric'],
  ['evaluate - --certify', 'not expected: --certify'],
  ['optimize - --functional bending --density 0', "'0' is not an integer from 1 to 64"],
  ['optimize - --functional bending -o a.obj --limit-mesh ./a.obj', 'two results would go to ./a.obj'],
  ['optimize - --functional bending -o - --report -', 'two results would go to -'],
];

describe('a command line that makes no sense', () => {
  test.each(senseless)('"%s" ends with 2 and says why', (line, reason) => {
    const { code, out, err } = umbilic(line ? line.split(' ') : [], {
      input: tetrahedron,
      folder: scratch.folder,
    });
    expect(err).toContain(reason);
    expect({ code, out }).toEqual({ code: 2, out: '' });
  });
});
