/**
 * Session: what the desktop works with, without any Swing: the controller at its own pace, the open
 * programs, and what may be done with both at the moment. Open {@link
 * org.pendant.desktop.session.RobotSession} first.
 */
package org.pendant.desktop.session;
