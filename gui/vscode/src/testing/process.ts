/** Runs `pendant test` and reads its reports. */
import { spawn } from 'node:child_process';
import * as fs from 'node:fs/promises';
import * as os from 'node:os';
import * as path from 'node:path';
import { readJunit, type TestReport } from './junit';
import { readLcov, type FileReach } from './lcov';

export interface TestCommand {
  readonly command: string;
  readonly folder: string;
  /** Behind `pendant test`. */
  readonly arguments: readonly string[];
  readonly coverage: boolean;
}

export interface TestRunResult {
  readonly report: TestReport;
  readonly reach: readonly FileReach[];
}

/**
 * Runs tests to their end.
 *
 * @param output gets what Pendant tells, as it comes
 * @param stop ends it: tests that run come to their end, no more begin
 * @throws Error where Pendant did not come to write a report
 */
export async function runTests(
  tests: TestCommand,
  output: (text: string) => void,
  stop: AbortSignal,
): Promise<TestRunResult> {
  const reports = await fs.mkdtemp(path.join(os.tmpdir(), 'pendant-tests-'));
  try {
    const junit = path.join(reports, 'tests.xml');
    const lcov = path.join(reports, 'coverage.info');
    const options = ['--junit', junit, '--verbose', '--color', 'always', ...(tests.coverage ? ['--lcov', lcov] : [])];
    const code = await run(tests, ['test', ...options, ...tests.arguments], output, stop);
    const xml = await fs.readFile(junit, 'utf8').catch(() => {
      throw new Error(`pendant test ended with ${code} and wrote no report; the output says why`);
    });
    const reach = tests.coverage ? readLcov(await fs.readFile(lcov, 'utf8').catch(() => '')) : [];
    return { report: readJunit(xml), reach };
  } finally {
    await fs.rm(reports, { recursive: true, force: true });
  }
}

function run(
  tests: TestCommand,
  args: readonly string[],
  output: (text: string) => void,
  stop: AbortSignal,
): Promise<string> {
  return new Promise((resolve, reject) => {
    const child = spawn(tests.command, args, { cwd: tests.folder, stdio: ['ignore', 'pipe', 'pipe'] });
    const interrupt = () => child.kill('SIGINT');
    stop.addEventListener('abort', interrupt);
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding('utf8');
      stream.on('data', output);
    }
    child.on('error', reject);
    child.on('close', (code, signal) => {
      stop.removeEventListener('abort', interrupt);
      resolve(signal ?? String(code));
    });
    if (stop.aborted) {
      interrupt();
    }
  });
}
