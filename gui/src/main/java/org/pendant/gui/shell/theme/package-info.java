/**
 * How the desktop looks: themes, scale and icons. Open {@link org.pendant.gui.shell.theme.Look}
 * first.
 */
package org.pendant.gui.shell.theme;
