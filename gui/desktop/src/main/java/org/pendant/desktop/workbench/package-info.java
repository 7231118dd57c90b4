/**
 * Workbench: what the parts of the window and the window agree on. Open {@link
 * org.pendant.desktop.workbench.View} first.
 */
package org.pendant.desktop.workbench;
