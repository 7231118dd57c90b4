package org.pendant.protocols.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Inet4Address;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/**
 * Pcap writer: packets in the format of libpcap (draft-ietf-opsawg-pcap, version 2.4,
 * LINKTYPE_RAW): each has an IP header (RFC 791, RFC 8200), a TCP header (RFC 9293) and bytes.
 */
final class PcapWriter implements Closeable {
  private static final int MAGIC_MICROSECONDS = 0xA1B2C3D4;
  private static final int LINKTYPE_RAW = 101;
  private static final int MAX_PACKET = 1 << 16;
  private static final int IPV4_BYTES = 20;
  private static final int IPV6_BYTES = 40;
  private static final int TCP_BYTES = 20;
  private static final int TCP = 6;
  private static final int HOPS = 64;
  private static final int WINDOW = 0xFFFF;
  private static final long SECOND_US = 1_000_000;

  private final OutputStream file;

  /**
   * What stands in the headers of a packet.
   *
   * @param number of its first byte
   * @param acknowledged the number that its sender expects next
   */
  record Segment(
      InetSocketAddress from, InetSocketAddress to, int number, int acknowledged, int flags) {}

  /** Begins a file; closes it at the end. */
  PcapWriter(OutputStream file) throws IOException {
    this.file = file;
    ByteBuffer head = ByteBuffer.allocate(24);
    head.putInt(MAGIC_MICROSECONDS).putShort((short) 2).putShort((short) 4);
    head.putInt(0).putInt(0).putInt(MAX_PACKET).putInt(LINKTYPE_RAW);
    file.write(head.array());
  }

  /** Writes a packet. */
  void write(long epochUs, Segment segment, ByteBuffer bytes) throws IOException {
    boolean four =
        segment.from().getAddress() instanceof Inet4Address
            && segment.to().getAddress() instanceof Inet4Address;
    int ip = four ? IPV4_BYTES : IPV6_BYTES;
    int length = ip + TCP_BYTES + bytes.remaining();
    ByteBuffer packet = ByteBuffer.allocate(16 + length);
    packet.putInt((int) (epochUs / SECOND_US)).putInt((int) (epochUs % SECOND_US));
    packet.putInt(length).putInt(length);
    ByteBuffer body = packet.slice(16, length);
    if (four) {
      putIpv4(body, segment, length);
    } else {
      putIpv6(body, segment, length - IPV6_BYTES);
    }
    putTcp(body, segment);
    body.put(bytes.duplicate());
    int tcpLength = length - ip;
    int addresses = four ? 8 : 32;
    long sum = sum(body, ip - addresses, addresses) + TCP + tcpLength + sum(body, ip, tcpLength);
    body.putShort(ip + 16, folded(sum));
    file.write(packet.array());
  }

  private static void putIpv4(ByteBuffer body, Segment segment, int length) {
    body.put((byte) 0x45).put((byte) 0).putShort((short) length).putInt(0);
    body.put((byte) HOPS).put((byte) TCP).putShort((short) 0);
    body.put(segment.from().getAddress().getAddress());
    body.put(segment.to().getAddress().getAddress());
    body.putShort(10, folded(sum(body, 0, IPV4_BYTES)));
  }

  private static void putIpv6(ByteBuffer body, Segment segment, int length) {
    body.putInt(0x60000000).putShort((short) length).put((byte) TCP).put((byte) HOPS);
    body.put(six(segment.from())).put(six(segment.to()));
  }

  /** An address in sixteen bytes, also one of four (RFC 4291, 2.5.5.2). */
  private static byte[] six(InetSocketAddress address) {
    byte[] bytes = address.getAddress().getAddress();
    return bytes.length == 16
        ? bytes
        : ByteBuffer.allocate(16).putShort(10, (short) 0xFFFF).position(12).put(bytes).array();
  }

  private static void putTcp(ByteBuffer body, Segment segment) {
    body.putShort((short) segment.from().getPort()).putShort((short) segment.to().getPort());
    body.putInt(segment.number()).putInt(segment.acknowledged());
    body.put((byte) ((TCP_BYTES / 4) << 4)).put((byte) segment.flags());
    body.putShort((short) WINDOW).putShort((short) 0).putShort((short) 0);
  }

  /** The sum of words of two bytes (RFC 1071). */
  private static long sum(ByteBuffer bytes, int from, int count) {
    long sum = 0;
    for (int i = 0; i < count; i++) {
      int each = Byte.toUnsignedInt(bytes.get(from + i));
      sum += i % 2 == 0 ? each << 8 : each;
    }
    return sum;
  }

  private static short folded(long sum) {
    long folded = sum;
    while (folded >> 16 != 0) {
      folded = (folded & 0xFFFF) + (folded >> 16);
    }
    return (short) ~folded;
  }

  /** Puts what was written where others see it. */
  void flush() throws IOException {
    file.flush();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
