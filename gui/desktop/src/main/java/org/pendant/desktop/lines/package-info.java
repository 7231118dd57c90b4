/**
 * What the lines and nodes of a program took of its last run, as it stands beside them. Open {@link
 * org.pendant.desktop.lines.PathStrip} first.
 */
package org.pendant.desktop.lines;
