/**
 * Panels that show where a program is held, its values, threads and breakpoints, and let it go on.
 * Open {@link org.pendant.desktop.debug.DebugPresenter} first; docs/debugging.md has the rules.
 */
package org.pendant.desktop.debug;
