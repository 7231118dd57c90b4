import assert from 'node:assert/strict';
import * as fs from 'node:fs';
import { test } from 'node:test';
import { arms } from 'pendant:arms';
import { meshes, places } from '../src/webview/bodies';
import { turnedBy } from '../src/webview/matrix';

const ur5e = arms['ur5e'];
assert.ok(ur5e !== undefined);

const near = (found: readonly number[] | undefined, expected: readonly number[]) =>
  expected.forEach((each, i) => assert.ok(Math.abs((found?.[i] ?? NaN) - each) < 1e-6, `${found} is not ${expected}`));

test('a stretched arm has its flange where its lengths say', () => {
  const flange = places(ur5e, [0, 0, 0, 0, 0, 0])[6];
  near(flange?.slice(12, 15), [-0.425 - 0.3922, -0.1333 - 0.0996, 0.1625 - 0.0997]);
});

test('an upright arm is as high as it is long', () => {
  const flange = places(ur5e, [0, -Math.PI / 2, 0, -Math.PI / 2, 0, 0])[6];
  near(flange?.slice(12, 15), [0, -0.1333 - 0.0996, 0.1625 + 0.425 + 0.3922 + 0.0997]);
});

test('the base turns everything above it', () => {
  const turned = places(ur5e, [Math.PI / 2, 0, 0, 0, 0, 0]);
  near(turned[0]?.slice(0, 3), [1, 0, 0]);
  near(turned[6]?.slice(12, 14), [0.1333 + 0.0996, -0.425 - 0.3922]);
});

test('a rotation vector turns by its length', () => {
  near(turnedBy([0, 0, Math.PI / 2]).slice(0, 3), [0, 1, 0]);
  near(turnedBy([0, 0, 0]).slice(0, 3), [1, 0, 0]);
});

test('bodies of all arms are closed in by normals of length one', () => {
  for (const arm of Object.values(arms)) {
    const all = meshes(arm);
    assert.equal(all.length, 7);
    for (const mesh of all) {
      assert.ok(mesh.length > 0 && mesh.length % 18 === 0 && mesh.every(Number.isFinite));
      for (let i = 3; i < mesh.length; i += 6) {
        assert.ok(Math.abs(Math.hypot(mesh[i] ?? 0, mesh[i + 1] ?? 0, mesh[i + 2] ?? 0) - 1) < 1e-9);
      }
    }
  }
});

test('launch.json offers the arms that there are', () => {
  const { contributes } = JSON.parse(fs.readFileSync('package.json', 'utf8'));
  const offered = contributes.debuggers[0].configurationAttributes.launch.properties.robot.anyOf[0].enum;
  assert.deepEqual([...offered].sort(), Object.keys(arms).sort());
});
