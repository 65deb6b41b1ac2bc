// SPDX-License-Identifier: MIT
/**
 * @file What libFuzzer prints is read rightly, and every target has a corpus and is one of the C++ targets.
 */
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { askedFor, outcomeOf, targets } from './fuzz.js';
import { root } from './process.js';

const ending = `#2048	pulse  cov: 311 ft: 700 corp: 9/180b lim: 24 exec/s: 1024 rss: 60Mb
#4096	DONE   cov: 312 ft: 720 corp: 11/201b lim: 43 exec/s: 2048 rss: 61Mb
Done 4096 runs in 2 second(s)
stat::number_of_executed_units: 4096
stat::average_exec_per_sec:     2048
stat::new_units_added:          10
`;

describe('the outcome', () => {
  test('of a run without a finding', () => {
    expect(outcomeOf(ending)).toEqual({ executions: 4096, perSecond: 2048, edges: 312, finding: '' });
  });

  test.each([
    [
      'broken promise: an answer is JSON\n==7== ERROR: libFuzzer: deadly signal\nSUMMARY: libFuzzer: deadly signal\n',
      'broken promise: an answer is JSON',
    ],
    [
      'a.cpp:3:4: runtime error: signed integer overflow\nSUMMARY: UndefinedBehaviorSanitizer: undefined\n',
      'a.cpp:3:4: runtime error: signed integer overflow',
    ],
    [
      'SUMMARY: AddressSanitizer: heap-buffer-overflow a.cpp:3 in f\n',
      'SUMMARY: AddressSanitizer: heap-buffer-overflow a.cpp:3 in f',
    ],
  ])('names a finding: %j', (text, words) => {
    const written = "artifact_prefix='x/'; Test unit written to build/fuzz/findings/cages-crash-0a\n";
    expect(outcomeOf(ending + text + written).finding).toBe(`cages-crash-0a: ${words}`);
  });

  test('of a program that did not run has no numbers', () => expect(outcomeOf('').executions).toBeNaN());
});

test('the command takes minutes and targets', () => {
  expect(askedFor([])).toEqual({ minutes: 1, chosen: targets });
  expect(askedFor(['contract', '--minutes', '0.5'])).toEqual({ minutes: 0.5, chosen: ['contract'] });
  for (const wrong of [['--minutes'], ['--minutes', '-1'], ['--minutes', 'many'], ['meshes']])
    expect(askedFor(wrong)).toBeNull();
});

test('each target has a corpus, and is known to C++', () => {
  const header = readFileSync(path.join(root, 'tests/fuzz/targets.h'), 'utf8');
  expect([...header.matchAll(/\{"(\w+)", \1\}/g)].map(([, name]) => name)).toEqual(targets);
  expect(readdirSync(path.join(root, 'tests/fuzz/corpus')).sort()).toEqual([...targets].sort());
});
