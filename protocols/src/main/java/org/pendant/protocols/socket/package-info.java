/**
 * TCP sockets of scripts. Open {@link org.pendant.protocols.socket.ScriptSockets} first; what
 * scripts make of the bytes is the controller's business.
 */
package org.pendant.protocols.socket;
