package org.pendant.protocols.eip;

import java.nio.ByteBuffer;

/** Connection name: tells the connections of all originators apart. */
record ConnectionName(int serial, int vendor, int originatorSerial) {
  static ConnectionName decode(ByteBuffer in) {
    int serial = Short.toUnsignedInt(in.getShort());
    int vendor = Short.toUnsignedInt(in.getShort());
    return new ConnectionName(serial, vendor, in.getInt());
  }

  LittleEndian encode(LittleEndian out) {
    return out.u16(serial).u16(vendor).u32(originatorSerial);
  }
}
