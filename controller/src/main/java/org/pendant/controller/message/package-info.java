/**
 * What the controller tells people: log lines and popups, numbered so that a slow reader can ask
 * for what it missed. Open {@link org.pendant.controller.message.MessageLog} first, then {@link
 * org.pendant.controller.message.PopupBoard}.
 */
package org.pendant.controller.message;
