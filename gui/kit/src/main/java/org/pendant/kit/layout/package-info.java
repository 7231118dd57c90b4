/**
 * Layouts that fit narrow docks and wide screens alike. Open {@link
 * org.pendant.kit.layout.WrappingRow} first.
 */
package org.pendant.kit.layout;
