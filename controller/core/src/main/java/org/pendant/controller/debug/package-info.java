/**
 * Stops a running program, shows it and lets it go on: breakpoints, steps, values. Open {@link
 * org.pendant.controller.debug.Debugger} first; docs/debugging.md says what holding a frame means.
 */
package org.pendant.controller.debug;
