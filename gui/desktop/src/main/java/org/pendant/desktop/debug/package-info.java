/**
 * Debugger panels: show where a program is paused, its values, threads and breakpoints, and let it
 * continue. Open {@link org.pendant.desktop.debug.DebugPresenter} first; docs/debugging.md has the
 * rules.
 */
package org.pendant.desktop.debug;
