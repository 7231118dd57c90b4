/**
 * Where the views are: the main area and docks at its sides. Open {@link
 * org.pendant.gui.shell.dock.DockFrame} first; {@link org.pendant.gui.shell.dock.DockPlan} is what
 * is remembered of it.
 */
package org.pendant.gui.shell.dock;
