/**
 * Layouts that fit narrow docks and wide screens alike. Open {@link
 * org.pendant.gui.layout.WrappingRow} first.
 */
package org.pendant.gui.layout;
