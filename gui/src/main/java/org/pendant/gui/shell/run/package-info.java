/** The Run screen. Open {@link org.pendant.gui.shell.run.RunView} first. */
package org.pendant.gui.shell.run;
