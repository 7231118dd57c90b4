// What a client of the debug adapter waits for, ten minutes into a program, ms. The client is Microsoft's:
//   npm install --prefix FOLDER @vscode/debugadapter-testsupport@1.68.0
//   NODE_PATH=FOLDER/node_modules node src/test/bench/dap.cjs ./pendant
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { DebugClient } = require('@vscode/debugadapter-testsupport');

const PROGRAM = `def main():
  q = [0, -1.57, -1.57, -1.57, 1.57, 0]
  movej(q, t=2)
  n = 0
  while n < 300:
    n = n + 1
    q[0] = 0.3
    movej(q, t=1)
    q[0] = 0
    movej(q, t=1)
  end
  last = 1
end
`;

const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'dap-')), 'long.script');
fs.writeFileSync(file, PROGRAM);

function row(name, all) {
  const sorted = [...all].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))].toFixed(1);
  console.log(`| ${name} | ${all[0].toFixed(1)} | ${at(0.5)} | ${at(0.95)} | ${at(1)} |`);
}

async function main() {
  const dap = new DebugClient(process.argv[2], 'dap', 'pendant', undefined, true);
  dap.defaultTimeout = 300_000;
  await dap.start();
  await dap.initializeRequest({ adapterID: 'pendant', linesStartAt1: true, columnsStartAt1: true, pathFormat: 'path' });
  const ready = dap.waitForEvent('initialized');
  await dap.launch({ program: file });
  await ready;
  await dap.setBreakpointsRequest({ source: { path: file }, breakpoints: [{ line: 3 }, { line: 12 }] });
  const timed = async (request) => {
    const stopped = dap.waitForEvent('stopped');
    const begin = process.hrtime.bigint();
    await request();
    await stopped;
    return Number(process.hrtime.bigint() - begin) / 1e6;
  };
  const many = async (name, count, request) => {
    const all = [];
    for (let i = 0; i < count; i++) {
      all.push(await timed(() => request(i)));
    }
    row(name, all);
  };
  await timed(() => dap.configurationDoneRequest());
  const threadId = 1;
  console.log('| what | first | median | 95 of 100 | most |');
  await many('a frame on, the arm moves', 400, () => dap.nextRequest({ threadId, granularity: 'instruction' }));
  console.error(`ten minutes took ${(await timed(() => dap.continueRequest({ threadId }))) / 1000} s`);
  await many('the previous statement', 40, () => dap.stepBackRequest({ threadId }));
  await many('back to where the last move began', 20, () => dap.customRequest('pendant/stepToMove', { threadId, back: true }));
  await many('a frame back', 100, () => dap.stepBackRequest({ threadId, granularity: 'instruction' }));
  await many('to a time', 20, (i) => dap.customRequest('pendant/goToTime', { timeS: 590 - 9 * i }));
  await dap.setBreakpointsRequest({ source: { path: file }, breakpoints: [] });
  await many('reverse continue to the beginning of the recording', 1, () => dap.reverseContinueRequest({ threadId }));
  await dap.disconnectRequest({});
  process.exit(0);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
