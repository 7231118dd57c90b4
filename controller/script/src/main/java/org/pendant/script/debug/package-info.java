/**
 * Debugger: stops a running program, shows it and lets it continue: breakpoints, steps, values.
 * Open {@link org.pendant.script.debug.Debugger} first; docs/debugging.md says what holding a frame
 * means.
 */
package org.pendant.script.debug;
