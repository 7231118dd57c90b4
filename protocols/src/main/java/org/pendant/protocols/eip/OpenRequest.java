package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Open request: what a Forward_Open or Large_Forward_Open asks for (CIP volume 1, 3-5.5.2).
 *
 * @param toOriginatorId number that the originator gives packets to it
 * @param timeoutMultiplier 4 times 2 to the power of this many intervals without a packet
 * @param toTargetUs interval of packets to the target, µs
 * @param toOriginatorUs interval of packets to the originator, µs
 * @param transport class and trigger
 */
record OpenRequest(
    int toOriginatorId,
    ConnectionName name,
    int timeoutMultiplier,
    long toTargetUs,
    ConnectionParameters toTarget,
    long toOriginatorUs,
    ConnectionParameters toOriginator,
    int transport,
    CipPath path) {
  private static final int MAX_MULTIPLIER = 7;
  private static final int SHORT_FIXED = 36;
  private static final int LARGE_FIXED = 40;

  /**
   * Takes the data of a request apart.
   *
   * @param large whether sizes have 32 bits
   * @throws CipRefusal if they are too short or too long, or the path or a number cannot be
   */
  static OpenRequest decode(ByteBuffer data, boolean large) throws CipRefusal {
    ByteBuffer in = data.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < (large ? LARGE_FIXED : SHORT_FIXED)) {
      throw new CipRefusal(CipRefusal.TOO_SHORT);
    }
    // how long the request itself may take, and a number for packets to us that we choose
    in.position(in.position() + 6);
    int toOriginatorId = in.getInt();
    ConnectionName name = ConnectionName.decode(in);
    int multiplier = Byte.toUnsignedInt(in.get());
    in.position(in.position() + 3);
    long toTargetUs = Integer.toUnsignedLong(in.getInt());
    ConnectionParameters toTarget = parameters(in, large);
    long toOriginatorUs = Integer.toUnsignedLong(in.getInt());
    ConnectionParameters toOriginator = parameters(in, large);
    int transport = Byte.toUnsignedInt(in.get());
    int pathBytes = 2 * Byte.toUnsignedInt(in.get());
    if (in.remaining() < pathBytes) {
      throw new CipRefusal(CipRefusal.TOO_SHORT);
    }
    if (in.remaining() > pathBytes) {
      throw new CipRefusal(CipRefusal.TOO_LONG);
    }
    if (multiplier > MAX_MULTIPLIER) {
      throw CipRefusal.connection(ConnectionFault.TYPE);
    }
    return new OpenRequest(
        toOriginatorId,
        name,
        multiplier,
        toTargetUs,
        toTarget,
        toOriginatorUs,
        toOriginator,
        transport,
        CipPath.decode(in));
  }

  private static ConnectionParameters parameters(ByteBuffer in, boolean large) {
    return large
        ? ConnectionParameters.ofLong(in.getInt())
        : ConnectionParameters.ofShort(Short.toUnsignedInt(in.getShort()));
  }

  /** 1 for cyclic data, 3 for messages. */
  int transportClass() {
    return transport & 0x0F;
  }

  /** How long the originator may be silent, ns. */
  long timeoutNs() {
    return toTargetUs * 1000 * (4L << timeoutMultiplier);
  }
}
