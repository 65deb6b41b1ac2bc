// SPDX-License-Identifier: MIT
/**
 * @file No two types of a namespace have the same name, and the check finds two that do.
 */
import { expect, test } from '@jest/globals';
import { readTree } from './tree.js';
import { repeatedTypes, typesOf } from './types.js';

test('the project has no two types of one name in a namespace', () => expect(repeatedTypes(readTree())).toEqual([]));

test('the types of a file are those in named namespaces, however they are written', () => {
  const text = `
    // struct Comment {
    namespace umbilic {
    struct Forward;
    template <class T>
    class [[nodiscard]] Result final : public Base<T> { struct Inner {}; enum class Kind { kOne }; };
    enum class Cap : int { kNone };
    namespace { struct Hidden {}; }
    void f() { struct Local {}; const char c = '{'; const char* s = "struct S {"; }
    namespace detail { union Bits { int i; }; }
    }
    struct umbilic_mesh { int a; };
    namespace umbilic::cli { struct Arguments {}; template <class T> T g(T t) { return t; } }`;
  expect(typesOf(text)).toEqual([
    'umbilic::Result',
    'umbilic::Cap',
    'umbilic::detail::Bits',
    'umbilic_mesh',
    'umbilic::cli::Arguments',
  ]);
});

test('the check finds two programs with types of one name', () => {
  const objective = 'namespace umbilic { class Objective { int x; }; }';
  const files = new Map([
    ['core/solve/objective.h', objective],
    ['core/cli/arguments.h', 'namespace umbilic { struct Objective { double x; }; }'],
    ['core/cli/other.h', 'namespace umbilic::cli { struct Objective { double x; }; }'],
  ]);
  expect(repeatedTypes(files)).toEqual(['umbilic::Objective is in core/solve/objective.h, core/cli/arguments.h']);
});
