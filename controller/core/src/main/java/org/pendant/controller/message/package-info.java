/**
 * Messages: what the controller tells people and asks them: log lines, popups and questions,
 * numbered so that a slow reader can ask for what it missed. Open {@link
 * org.pendant.controller.message.MessageLog} first, then {@link
 * org.pendant.controller.message.OpenPopups} and {@link
 * org.pendant.controller.message.PromptQueue}.
 */
package org.pendant.controller.message;
