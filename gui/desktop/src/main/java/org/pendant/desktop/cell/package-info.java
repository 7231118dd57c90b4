/**
 * The Cell screen: what stands around the arm and hangs on its flange, {@link
 * org.pendant.desktop.cell.CellView} first.
 */
package org.pendant.desktop.cell;
