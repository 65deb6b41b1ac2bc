// SPDX-License-Identifier: MIT
/**
 * @file A project that uses this one keeps its own compiler settings: the libraries do not pass on warnings,
 * optimization and output folders.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { beforeAll, expect, test } from '@jest/globals';
import { root } from './tree.js';

const folder = path.join(root, 'build/architecture/parent');
const listFile = `
  cmake_minimum_required(VERSION 3.25)
  project(parent LANGUAGES CXX)
  get_directory_property(before VARIABLES)
  add_subdirectory("${root}" umbilic)
  get_directory_property(after VARIABLES)
  list(REMOVE_ITEM after \${before} before)
  list(FILTER after EXCLUDE REGEX "^(UMBILIC|umbilic)_")
  message(NOTICE "added: \${after}")
  message(NOTICE "build type: '\${CMAKE_BUILD_TYPE}'")
  add_executable(parent parent.cpp)
  target_link_libraries(parent PRIVATE umbilic::core)
  add_executable(parent_of_c parent_of_c.cpp)
  target_link_libraries(parent_of_c PRIVATE umbilic::c)
  get_property(programs DIRECTORY "${root}/core" PROPERTY BUILDSYSTEM_TARGETS)
  list(FILTER programs INCLUDE REGEX "^umbilic$|catalog")
  message(NOTICE "programs: '\${programs}'")
`;

/** @type {string} */
let said;
/** @type {{ file: string, command: string }[]} */
let commands;

beforeAll(() => {
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, 'CMakeLists.txt'), listFile);
  writeFileSync(path.join(folder, 'parent.cpp'), '#include <umbilic/driver/problem_run.h>\nint main() {}\n');
  writeFileSync(path.join(folder, 'parent_of_c.cpp'), '#include <umbilic/api.h>\nint main() {}\n');
  const build = path.join(folder, 'build');
  const settings = ['-G', 'Ninja', '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'];
  const { status, stderr } = spawnSync('cmake', ['-S', folder, '-B', build, ...settings], { encoding: 'utf8' });
  expect({ status, stderr }).toMatchObject({ status: 0 });
  said = stderr;
  commands = JSON.parse(readFileSync(path.join(build, 'compile_commands.json'), 'utf8'));
});

/** @param {string} file @returns {string} */
const commandFor = (file) => commands.find((entry) => entry.file.endsWith(file))?.command ?? '';

/** @param {string} file @returns {string[]} its compiler options, without include folders and language */
function optionsFor(file) {
  const command = commandFor(file);
  expect(command).not.toBe('');
  return command
    .replace(/ -(isystem|o|c) \S+/g, '')
    .split(/\s+/)
    .slice(1)
    .filter((option) => option && !/^-(I|std=)/.test(option));
}

test('a program that links the library is compiled with nothing of ours', () => {
  expect(optionsFor('parent.cpp')).toEqual([]);
  expect(optionsFor('parent_of_c.cpp')).toEqual([]);
});

test('a program finds the headers by the names that they have once installed', () => {
  for (const file of ['parent.cpp', 'parent_of_c.cpp']) {
    const [compiler, ...options] = commandFor(file)
      .replace(/ -(o|c) \S+/g, '')
      .split(/\s+/);
    const args = [...options, '-fsyntax-only', path.join(folder, file)];
    expect(spawnSync(compiler, args, { encoding: 'utf8' })).toMatchObject({ status: 0 });
  }
});

test('the library itself is compiled without our warnings and at the level that the other project chooses', () => {
  const own = optionsFor(path.join('core', 'cage', 'generate.cpp'));
  expect(own.filter((option) => /^-(W|O|g|DNDEBUG)/.test(option))).toEqual([]);
  expect(own).toContain('-ffp-contract=off'); // options that affect results stay with the library
});

test('the other project has no build type, output folder, program and test that it did not ask for', () => {
  expect(said).toMatch("build type: ''");
  expect(said).toMatch("programs: ''");
  expect(
    said
      .match(/^added: (.*)$/m)?.[1]
      .split(';')
      .filter((name) => /OUTPUT|FLAGS|UNITY|LAUNCHER/.test(name)),
  ).toEqual([]);
  expect(commands.filter(({ file }) => file.startsWith(path.join(root, 'tests')))).toEqual([]);
});
