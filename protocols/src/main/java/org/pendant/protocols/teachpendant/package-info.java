/**
 * Teach pendant without a screen: the loaded program, popups, operational mode, reports. The
 * dashboard server works it by lines of text, a desktop may by buttons. Open {@link
 * org.pendant.protocols.teachpendant.RemotePendant} first.
 */
package org.pendant.protocols.teachpendant;
