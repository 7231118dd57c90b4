/**
 * What the parts of the window and the window agree on. Open {@link org.pendant.gui.workbench.View}
 * first.
 */
package org.pendant.gui.workbench;
