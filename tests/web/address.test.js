// SPDX-License-Identifier: MIT
/**
 * @file The addresses of all pages: what is written is read back, what means nothing falls back and is told.
 */
import { describe, expect, test } from '@jest/globals';
import { firstCamera, roundCamera, sameCamera } from '../../web/address/camera.js';
import { formatCatalogAddress, parseCatalogAddress } from '../../web/address/catalog.js';
import { entryName, formatCompareAddress, parseCompareAddress } from '../../web/address/compare.js';
import { compareLink, studioLink } from '../../web/address/links.js';
import { formatStudioAddress, parseStudioAddress } from '../../web/address/studio.js';
import { formatTorusAddress, parseTorusAddress } from '../../web/address/torus.js';

/** @type {Record<string, {parse: (search: string) => {address: any, notices: string[]}, format: (address: any) => string}>} */
const pages = {
  studio: { parse: parseStudioAddress, format: formatStudioAddress },
  compare: { parse: parseCompareAddress, format: formatCompareAddress },
  torus: { parse: parseTorusAddress, format: formatTorusAddress },
  catalog: { parse: parseCatalogAddress, format: formatCatalogAddress },
};

describe('an address that was written is read back and written again to the letter', () => {
  test.each([
    ['studio', '?shape=two-3&functional=mvs_cross'],
    ['studio', '?shape=cube-frame'],
    ['studio', '?shape=two-3&functional=mvs_cross&shading=gaussian&camera=38.7,-22.1,1.204'],
    ['studio', '?shape=cube-frame&functional=bending&start=cage&family=hub&thickness=0.65'],
    ['studio', '?shape=torus&functional=blend&start=cage&weights=bending:0.95,mvs_cross:0.05&cap=flat&symmetry=off'],
    ['studio', '?shape=two-4&functional=mvs&start=cage&levels=1..4&shading=plain&camera=-180,90,0.05,0.1,-2,0'],
    ['compare', '?entries=two-3.bending,two-3.mvs_cross'],
    ['compare', '?entries=two-3.bending,cube-frame.mvs,torus.bending_mvs_cross,two-12.mvs_cross&shading=kappa2'],
    ['compare', '?entries=two-3.bending,two-3.mvs&camera=0,0,2.5'],
    ['torus', '?weights=bending:1,mvs_cross:1'],
    ['torus', '?weights=mehlum_tarrou:0,willmore:3&shading=plain&camera=12,80,1'],
    ['torus', '?weights=bending:1,mvs_cross:1e-7'],
    ['catalog', ''],
    ['catalog', '?sort=mvs_cross&direction=desc&genus=3&search=two%20junctions%20%26%20more%2B'],
    ['catalog', '?genus=0&arms=12&group=D12h&status=upper_bound&entry=two-12.mvs_cross'],
  ])('%s%s', (page, search) => {
    const { parse, format } = pages[page];
    const { address, notices } = parse(search);
    expect(notices).toEqual([]);
    expect(format(address)).toBe(search);
    expect(parse(format(address)).address).toEqual(address);
  });

  test('short ones mean the page as it opens, and links that name an entry are enough to open it', () => {
    expect(parseStudioAddress('').address).toMatchObject({ shape: 'two-3', functional: '', shading: 'mean' });
    expect(parseStudioAddress('?shape=two-3&functional=mvs').address).toMatchObject({ start: 'catalog', thickness: 1 });
    expect(parseCompareAddress('').address.entries.map(entryName)).toEqual([
      'two-3.bending',
      'two-3.mvs',
      'two-3.mvs_cross',
    ]);
    expect(parseTorusAddress('').address.weights).toEqual({ bending: 1, mvs_cross: 1 });
  });
});

describe('a value that means nothing falls back, and one sentence quotes it and says what is possible', () => {
  test.each([
    ['studio', 'shape=Two 3', { shape: 'two-3' }],
    ['studio', 'functional=<b>', { functional: '' }],
    ['studio', 'start=here', { start: 'catalog' }],
    ['studio', 'family=square', { family: 'flag' }],
    ['studio', 'thickness=9', { thickness: 1 }],
    ['studio', 'thickness=1,5', { thickness: 1 }],
    ['studio', 'weights=bending:0', { weights: {} }],
    ['studio', 'weights=bending:1,bending:2', { weights: {} }],
    ['studio', 'weights=length:1', { weights: {} }],
    ['studio', 'levels=3..1', { levels: [0, 2] }],
    ['studio', 'levels=0..9', { levels: [0, 2] }],
    ['studio', 'accuracy=2', { accuracy: 0 }],
    ['studio', 'shading=rainbow', { shading: 'mean' }],
    ['studio', 'camera=1,2', { camera: firstCamera }],
    ['studio', 'camera=1,2,NaN', { camera: firstCamera }],
    ['studio', 'camera=1,200,1', { camera: firstCamera }],
    ['studio', 'camera=1,2,0', { camera: firstCamera }],
    ['studio', 'camera=1,2,1,2', { camera: firstCamera }],
    ['compare', 'entries=two-3.bending', {}],
    ['compare', 'entries=two-3,two-4', {}],
    ['compare', 'entries=a.b,a.b,a.b,a.b,a.b', {}],
    ['torus', 'weights=bending:1', {}],
    ['torus', 'weights=bending:-1,mvs:1', {}],
    ['catalog', 'genus=-1', { genus: null }],
    ['catalog', 'direction=up', { direction: 'asc' }],
    ['catalog', 'arms=1e3', { arms: null }],
    ['catalog', 'group=<b>', { group: '' }],
    ['catalog', 'status=fine', { status: '' }],
    ['catalog', 'entry=two-3', { entry: '' }],
  ])('%s?%s', (page, search, expected) => {
    const { parse, format } = pages[page];
    const { address, notices } = parse(`?${search}`);
    const whole = parse('').address;
    expect(address).toEqual({ ...whole, ...expected });
    expect(notices).toHaveLength(1);
    expect(notices[0]).toContain(`“${search}”`);
    expect(notices[0]).toMatch(/may be .+\.$/);
    expect(format(address)).toBe(format(whole));
  });

  test('a very long one is quoted in part, and every broken one has its sentence', () => {
    const { notices } = parseStudioAddress(`?shading=${'x'.repeat(5000)}&camera=&family=hub`);
    expect(notices).toHaveLength(2);
    expect(notices[0].length).toBeLessThan(220);
  });

  test('parameters that are not of the page change nothing', () => {
    expect(parseStudioAddress('?from=mail&shape=two-4')).toEqual(parseStudioAddress('?shape=two-4'));
  });
});

test('the links of the catalog are addresses of the studio and of the comparison', () => {
  const entry = { shape: 'two-3', functional: 'mvs_cross' };
  expect(studioLink(entry)).toBe('./studio.html?shape=two-3&functional=mvs_cross');
  expect(compareLink([entry, { shape: 'torus', functional: 'mvs' }])).toBe(
    './compare.html?entries=two-3.mvs_cross,torus.mvs',
  );
});

describe('a camera', () => {
  test('is rounded once: rounding it again, or writing and reading it, changes nothing', () => {
    const camera = roundCamera({ azimuth: -0.04, elevation: 89.96, distance: 1.23456, target: [0.00049, -1 / 3, 7] });
    expect(camera).toEqual({ azimuth: 0, elevation: 90, distance: 1.235, target: [0, -0.333, 7] });
    expect(roundCamera(camera)).toEqual(camera);
    const search = formatCompareAddress({ ...parseCompareAddress('').address, camera });
    expect(parseCompareAddress(search).address.camera).toEqual(camera);
    expect(Object.is(camera.azimuth, 0)).toBe(true);
  });

  test('is the same where its address is', () => {
    const near = { ...firstCamera, azimuth: firstCamera.azimuth + 0.04 };
    const far = { ...firstCamera, azimuth: firstCamera.azimuth + 0.06 };
    expect(sameCamera(firstCamera, near)).toBe(true);
    expect(sameCamera(firstCamera, far)).toBe(false);
  });
});
