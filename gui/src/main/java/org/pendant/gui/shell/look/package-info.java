/**
 * How the desktop looks: themes, scale and icons. Open {@link org.pendant.gui.shell.look.Look}
 * first.
 */
package org.pendant.gui.shell.look;
