/**
 * The Run screen and what programs show to people. Open {@link org.pendant.gui.shell.run.RunView}
 * first.
 */
package org.pendant.gui.shell.run;
