/**
 * The window of the desktop: what is around the views. Open {@link org.pendant.gui.shell.Desktop}
 * first; {@link org.pendant.gui.shell.Views} lists what is in it.
 */
package org.pendant.gui.shell;
