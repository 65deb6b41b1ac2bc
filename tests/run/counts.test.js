// SPDX-License-Identifier: MIT
/**
 * @file The counts of `npm test` match the reports of GoogleTest and Jest, and a run without tests never passes.
 */
import { describe, expect, test } from '@jest/globals';
import { countGoogleTests, jobsOf } from './cpp_tests.js';
import { countJestTests } from './jest_tests.js';
import { expectSome, line, one, sum } from './tally.js';

describe('tallies', () => {
  test('add up', () => {
    expect(sum([one(true), one(false), { passed: 2, failed: 0, skipped: 3 }])).toEqual({
      passed: 3,
      failed: 1,
      skipped: 3,
    });
  });

  test('count no test as a failure', () => {
    expect(expectSome({ passed: 0, failed: 0, skipped: 0 }).failed).toBe(1);
    expect(expectSome({ passed: 1, failed: 0, skipped: 0 }).failed).toBe(0);
  });

  test('are one plain line, with the skipped only where there are any', () => {
    expect(line({ passed: 3, failed: 0, skipped: 0 })).toBe('3 passed, 0 failed');
    expect(line({ passed: 3, failed: 1, skipped: 2 })).toBe('3 passed, 1 failed, 2 skipped');
  });
});

test('GoogleTest: passed, failed, skipped by the test, left out by a filter or disabled', () => {
  const cases = [
    { status: 'RUN', result: 'COMPLETED' },
    { status: 'RUN', result: 'COMPLETED', failures: [{ failure: 'x' }] },
    { status: 'RUN', result: 'SKIPPED' },
    { status: 'NOTRUN', result: 'SUPPRESSED' },
  ];
  const report = JSON.stringify({ testsuites: [{ testsuite: cases }, { testsuite: [cases[0]] }] });
  expect(countGoogleTests(report)).toEqual({ passed: 2, failed: 1, skipped: 2 });
});

test('programs that take long are dealt out to several runs, which begin first and have all shards', () => {
  const jobs = jobsOf(['umbilic_test_base', 'umbilic_test_driver']);
  expect(jobs.at(-1)).toEqual({ name: 'umbilic_test_base', shard: 0, shards: 1 });
  const driver = jobs.slice(0, -1);
  expect(driver.map(({ name, shard, shards }) => [name, shard, shards])).toEqual(
    driver.map((_, shard) => ['umbilic_test_driver', shard, driver.length]),
  );
  expect(driver.length).toBeGreaterThan(1);
});

test('Jest: a file that does not run is a failure', () => {
  const counts = {
    numPassedTests: 4,
    numFailedTests: 1,
    numPendingTests: 2,
    numTodoTests: 1,
    numRuntimeErrorTestSuites: 1,
  };
  expect(countJestTests(JSON.stringify(counts))).toEqual({ passed: 4, failed: 2, skipped: 3 });
});
