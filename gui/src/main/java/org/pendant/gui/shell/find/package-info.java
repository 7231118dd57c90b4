/** Finding and rebinding actions. Open {@link org.pendant.gui.shell.find.CommandPalette} first. */
package org.pendant.gui.shell.find;
