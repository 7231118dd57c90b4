package org.pendant.protocols.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.wire.Direction;

class TcpStreamTest {
  private static final HexFormat HEX = HexFormat.of();
  private static final long TIME_US = 1_700_000_000_123_456L;

  private final ByteArrayOutputStream file = new ByteArrayOutputStream();

  private static Peers peers(String port, String client) throws IOException {
    return new Peers(
        "RTDE",
        new InetSocketAddress(InetAddress.getByName(port), 30004),
        new InetSocketAddress(InetAddress.getByName(client), 50000));
  }

  /** Source port, first number, acknowledged number, flags and bytes of each packet. */
  private List<String> packets(int ipBytes) {
    ByteBuffer in = ByteBuffer.wrap(file.toByteArray()).position(24);
    List<String> packets = new ArrayList<>();
    while (in.hasRemaining()) {
      assertEquals(TIME_US, in.getInt() * 1_000_000L + in.getInt());
      int length = in.getInt();
      assertEquals(length, in.getInt());
      ByteBuffer packet = in.slice(in.position(), length);
      in.position(in.position() + length);
      byte[] bytes = new byte[length - ipBytes - 20];
      packet.get(ipBytes + 20, bytes);
      packets.add(
          "%d %d %d %02x %s"
              .formatted(
                  packet.getShort(ipBytes) & 0xFFFF,
                  packet.getInt(ipBytes + 4),
                  packet.getInt(ipBytes + 8),
                  packet.get(ipBytes + 13),
                  HEX.formatHex(bytes)));
    }
    return packets;
  }

  @Test
  void numbersTheBytesOfBothSidesFromHandshakeToEnd() throws Exception {
    PcapWriter writer = new PcapWriter(file);
    TcpStream stream = new TcpStream(peers("127.0.0.1", "127.0.0.2"));
    stream.open(writer, TIME_US, false);
    stream.write(writer, TIME_US, Direction.IN, 0, ByteBuffer.wrap(new byte[] {1, 2, 3}));
    stream.write(writer, TIME_US, Direction.OUT, 0, ByteBuffer.wrap(new byte[] {4}));
    stream.end(writer, TIME_US);
    assertEquals(
        List.of(
            "50000 0 0 02 ",
            "30004 0 1 12 ",
            "50000 1 1 10 ",
            "50000 1 1 18 010203",
            "30004 1 4 18 04",
            "50000 4 2 11 ",
            "30004 2 5 11 ",
            "50000 5 3 10 "),
        packets(20));
  }

  @Test
  void leavesAGapInTheNumbersWhereBytesAreMissing() throws Exception {
    PcapWriter writer = new PcapWriter(file);
    TcpStream stream = new TcpStream(peers("127.0.0.1", "127.0.0.2"));
    stream.write(writer, TIME_US, Direction.OUT, 0, ByteBuffer.wrap(new byte[] {4}));
    stream.write(writer, TIME_US, Direction.OUT, 100, ByteBuffer.wrap(new byte[] {5}));
    assertEquals(List.of("30004 1 1 18 04", "30004 101 1 18 05"), packets(20));
  }

  @Test
  void cutsLongMessagesIntoPacketsOfAnEthernet() throws Exception {
    PcapWriter writer = new PcapWriter(file);
    TcpStream stream = new TcpStream(peers("127.0.0.1", "127.0.0.2"));
    stream.write(writer, TIME_US, Direction.IN, 0, ByteBuffer.allocate(2000));
    List<String> packets = packets(20);
    assertEquals("50000 1461 1 18 " + "00".repeat(540), packets.get(1));
  }

  @Test
  void writesVersionSixForAddressesOfSixteenBytes() throws Exception {
    PcapWriter writer = new PcapWriter(file);
    TcpStream stream = new TcpStream(peers("::1", "::1"));
    stream.write(writer, TIME_US, Direction.IN, 0, ByteBuffer.wrap(new byte[] {7}));
    assertEquals(List.of("50000 1 1 18 07"), packets(40));
  }

  @Test
  void hasTheChecksumsOfTheInternet() throws Exception {
    PcapWriter writer = new PcapWriter(file);
    TcpStream stream = new TcpStream(peers("10.0.0.1", "10.0.0.2"));
    stream.write(writer, TIME_US, Direction.IN, 0, ByteBuffer.wrap(new byte[] {'a', 'b', 'c'}));
    // as scapy 2.8.0 computes them
    ByteBuffer packet = ByteBuffer.wrap(file.toByteArray()).position(40).slice();
    assertEquals(
        "66cb 9edd",
        HEX.toHexDigits(packet.getShort(10)) + " " + HEX.toHexDigits(packet.getShort(36)));
  }
}
