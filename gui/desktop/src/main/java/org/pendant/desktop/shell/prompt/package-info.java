/**
 * Prompts: what programs show to people and ask them. Open {@link
 * org.pendant.desktop.shell.prompt.PromptPanel} first.
 */
package org.pendant.desktop.shell.prompt;
