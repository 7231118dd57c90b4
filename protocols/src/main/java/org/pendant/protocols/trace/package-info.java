/**
 * Wire trace: everything that goes over the connections of a controller, message by message, for
 * people and for files. Open {@link org.pendant.protocols.trace.WireTrace} first.
 */
package org.pendant.protocols.trace;
