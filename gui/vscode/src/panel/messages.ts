/** What the panel and its page tell each other. */
import type { Stop } from './stops';

/** To the page. */
export interface Show {
  readonly kind: 'show';
  readonly state: 'none' | 'running' | 'stopped' | 'ended';
  readonly stops: readonly Stop[];
}

/** From the page. */
export type Wish =
  | { readonly kind: 'ready' }
  | { readonly kind: 'open'; readonly stop: number }
  | { readonly kind: 'output'; readonly bank: string; readonly index: number; readonly on: boolean };
