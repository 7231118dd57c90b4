/**
 * What goes over a connection, for people: messages are cut out of its bytes and read, without
 * being obeyed. Open {@link org.pendant.protocols.wire.Dissector} first.
 */
package org.pendant.protocols.wire;
