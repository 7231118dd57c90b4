/**
 * Layout of a cell: the controllers that share it, where their arms stand, and how their signals
 * are wired. Open {@link org.pendant.controller.layout.CellLayout} first.
 */
package org.pendant.controller.layout;
