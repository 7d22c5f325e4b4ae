// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the example in QRELIEF_EXAMPLE, a folder in which the packed package is installed.
import { copyFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { Site } from '../../e2e/support/site.js';

const kPlate = fileURLToPath(new URL('../../public/samples/plate.stl', import.meta.url));
const folder = process.env.QRELIEF_EXAMPLE ?? '';

/** @type {Site} */ let site;
test.beforeAll(async () => {
  site = await new Site('/below/', folder).open();
});
test.afterAll(() => site.close());

test('The example engraves a model, and cancels', async ({ page }) => {
  await page.goto(site.address);
  const status = page.getByRole('status');
  await page.getByLabel('Model', { exact: true }).setInputFiles(kPlate);

  await test.step('Cancel stops it', async () => {
    await page.getByRole('button', { name: 'Engrave' }).click();
    await expect(status).not.toBeEmpty();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await expect(status).toHaveText('Cancelled.');
    await expect(page.getByRole('link')).toHaveCount(0);
  });

  await test.step('The result passes and can be downloaded', async () => {
    await page.getByRole('button', { name: 'Engrave' }).click();
    await expect(status).toHaveText(/^\d+\.\d mm wide; passed$/);
    for (const [name, file] of [
      ['Model', 'engraved.stl'],
      ['Report', 'engraved.json'],
    ]) {
      const download = page.waitForEvent('download');
      await page.getByRole('link', { name }).click();
      await copyFile(await (await download).path(), `${folder}/${file}`); // script/test-npm verifies them
    }
  });
});

test('An engine works in a worker, at a given centre, and says what it refuses', async ({ page }) => {
  await page.goto(site.address);
  const told = await page.evaluate(async () => {
    const source = `
      const { Engine } = await import('${new URL('node_modules/qrelief/npm/index.js', location.href)}');
      onmessage = async ({ data }) => {
        const engine = await Engine.start();
        const refused = await engine.configure({ colour: 1 }).catch(({ name, kind }) => [name, kind]);
        await engine.configure({ text: 'HTTPS://EXAMPLE.ORG', size: 25, process: 'none', carveFor: 'design' });
        const { sizeMm } = await engine.loadModel(data, 'cube.obj', { scaleToMm: 10 });
        const centre = await engine.setCentre([0, 0, 99]);
        const { symbolMm } = await engine.placement();
        const stages = new Set();
        const { verdict } = await engine.engrave({ onProgress: ({ stage }) => stages.add(stage.code) });
        const file = await engine.exportModel('3mf');
        engine.end();
        const ended = await engine.placement().catch(({ code }) => code);
        postMessage({ refused, sizeMm, centre, symbolMm, reads: verdict.reads.passed, stages: [...stages],
          file: String.fromCharCode(...file.slice(0, 2)), ended });
      };
      postMessage('ready');`;
    const worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })), { type: 'module' });
    const corners = [-2, 2].flatMap((x) => [-2, 2].flatMap((y) => [-1, 1].map((z) => `v ${x} ${y} ${z}`)));
    const sides = ['1 2 4 3', '5 7 8 6', '1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'].map((side) => `f ${side}`);
    const cube = new TextEncoder().encode([...corners, ...sides].join('\n'));
    return new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => (data === 'ready' ? worker.postMessage(cube) : resolve(data));
      worker.onerror = ({ message }) => reject(new Error(message));
    });
  });
  expect(told).toEqual({
    refused: ['EngineError', 'BadUsage'],
    sizeMm: [40, 40, 20],
    centre: [0, 0, 10],
    symbolMm: 25,
    reads: true,
    stages: expect.arrayContaining(['finding-depth', 'checking-solid']),
    file: 'PK',
    ended: 'engine-replaced',
  });
});
