package org.pendant.protocols.eip;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import org.pendant.protocols.script.RunningBox;

/** A scanner with one connection of cyclic data. */
final class Scanner implements AutoCloseable {
  private static final int RUN = 1;

  private final EipClient client;
  private final int serial;
  private final DatagramSocket socket;
  private final byte[] buffer = new byte[2048];
  private InetSocketAddress box = new InetSocketAddress(0);
  private int id;
  private int sent;

  /**
   * A scanner that has not asked for anything.
   *
   * @param serial of its connection; packets from the box have 0x70000 more
   */
  Scanner(EipClient client, int serial) throws IOException {
    this.client = client;
    this.serial = serial;
    socket = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
  }

  int toScannerId() {
    return 0x70000 + serial;
  }

  /** A Forward_Open. */
  String request(int us, int fromScanner, int fromBytes, int toScanner, int toBytes) {
    return Hex.text(
        new LittleEndian()
            .bytes(Hex.bytes("54 02 2006 2401 0A 0E 00000000"))
            .u32(toScannerId())
            .u16(serial)
            .bytes(Hex.bytes("3412 CDAB0000 05 000000"))
            .u32(us)
            .u16(0x4800 | (fromBytes + 6))
            .u32(us)
            .u16(0x4800 | (toBytes + 2))
            .bytes(Hex.bytes("01 04 2004 2401 2C"))
            .u8(fromScanner)
            .u8(0x2C)
            .u8(toScanner)
            .toArray());
  }

  /** Asks for a connection; answers status and extended status, 0 for an open one. */
  int open(String request) throws IOException {
    PacketItem socketItem =
        new PacketItem(
            PacketItem.SOCKET_TO_ORIGINATOR,
            new LittleEndian()
                .bytes(
                    Encapsulation.socket(new InetSocketAddress("0.0.0.0", socket.getLocalPort())))
                .toBuffer());
    List<PacketItem> items = client.exchange(request, List.of(socketItem));
    ByteBuffer answer = PacketItem.first(items, PacketItem.UNCONNECTED_DATA).orElseThrow().data();
    if (answer.get(2) != 0) {
      return answer.get(2) << 16 | answer.getShort(4);
    }
    id = answer.getInt(4);
    int port =
        Short.toUnsignedInt(
            PacketItem.first(items, PacketItem.SOCKET_TO_TARGET)
                .orElseThrow()
                .data()
                .order(ByteOrder.BIG_ENDIAN)
                .getShort(2));
    box = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    return 0;
  }

  /** Asks for the end of the connection; answers the general status. */
  int forwardClose() throws IOException {
    String answer =
        client.message(
            Hex.text(
                new LittleEndian()
                    .bytes(Hex.bytes("4E 02 2006 2401 0A 0E"))
                    .u16(serial)
                    .bytes(Hex.bytes("3412 CDAB0000 03 00 2004 2401 2C70 2C64"))
                    .toArray()));
    return Integer.parseInt(answer.substring(4, 6), 16);
  }

  /** The next packet from the box. */
  IoPacket receive() throws IOException {
    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
    socket.receive(packet);
    return IoPacket.decode(
            ByteBuffer.wrap(Arrays.copyOf(buffer, packet.getLength()))
                .order(ByteOrder.LITTLE_ENDIAN))
        .orElseThrow();
  }

  void run(byte[] data) throws IOException {
    send(RUN, data);
  }

  void idle(byte[] data) throws IOException {
    send(0, data);
  }

  private void send(int state, byte[] data) throws IOException {
    sent++;
    byte[] bytes =
        new IoPacket(id, sent, sent & 0xFFFF, new LittleEndian().u32(state).bytes(data).toBuffer())
            .encode();
    socket.send(new DatagramPacket(bytes, bytes.length, box));
  }

  @Override
  public void close() {
    socket.close();
  }
}
