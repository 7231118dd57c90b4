/**
 * Docks: where the views are: the main area and docks at its sides. Open {@link
 * org.pendant.kit.dock.DockFrame} first; {@link org.pendant.kit.dock.DockPlan} is what is
 * remembered of it.
 */
package org.pendant.kit.dock;
