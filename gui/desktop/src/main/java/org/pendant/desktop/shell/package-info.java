/**
 * Shell: the window of the desktop, around the views. Open {@link
 * org.pendant.desktop.shell.Desktop} first; {@link org.pendant.desktop.shell.Views} lists what is
 * in it.
 */
package org.pendant.desktop.shell;
