/**
 * Tool serial line: a serial device of this computer and a TCP port whose clients share it. Open
 * {@link org.pendant.protocols.toolserial.ToolSerialLine} first.
 */
package org.pendant.protocols.toolserial;
