/**
 * What programs show to people and ask them. Open {@link org.pendant.gui.shell.prompt.PromptPanel}
 * first.
 */
package org.pendant.gui.shell.prompt;
