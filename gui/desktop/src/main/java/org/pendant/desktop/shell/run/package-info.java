/** Run screen. Open {@link org.pendant.desktop.shell.run.RunView} first. */
package org.pendant.desktop.shell.run;
