/** Where a text is, as a debug session names it. */

/** The parts of a URI that matter here. */
interface Parts {
  readonly scheme: string;
  readonly path: string;
}

/**
 * The file behind the path of a source. Adapters name files; on its way through VS Code a path may become a URI,
 * as text or in parts.
 *
 * @return undefined where there is no file
 */
export function fileOf(path: unknown): string | undefined {
  if (typeof path === 'string') {
    const scheme = /^([a-z][a-z0-9+.-]+):\/\//i.exec(path)?.[1];
    if (scheme === undefined) {
      return path === '' ? undefined : path;
    }
    return onDisk(scheme) ? decodeURIComponent(new URL(path).pathname) : undefined;
  }
  if (typeof path === 'object' && path !== null && 'scheme' in path && 'path' in path) {
    const parts = path as Parts;
    return onDisk(parts.scheme) ? parts.path : undefined;
  }
  return undefined;
}

function onDisk(scheme: string): boolean {
  return scheme === 'file' || scheme === 'vscode-remote';
}
