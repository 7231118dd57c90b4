package org.pendant.protocols.trace;

import java.nio.ByteBuffer;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Reading;

/**
 * Wire message: one message of a client or to it.
 *
 * @param epochUs when its last byte came or went, us since 1970
 * @param robotTimeS the same by the robot, s
 * @param reading what it says
 * @param bytes read-only
 */
public record WireMessage(
    Peers peers,
    Direction direction,
    long epochUs,
    double robotTimeS,
    Reading reading,
    ByteBuffer bytes) {}
