/**
 * Protocols, by which clients reach a controller: each one that a control box speaks gets a package
 * of its own below this one, split into messages, framing and session. Open {@link
 * org.pendant.protocols.BoxPorts} first, which opens them all.
 */
package org.pendant.protocols;
