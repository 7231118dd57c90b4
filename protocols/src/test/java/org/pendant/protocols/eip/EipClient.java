package org.pendant.protocols.eip;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.protocols.script.RunningBox;

/** A client with a session, which sends bytes as they stand in a test. */
final class EipClient implements AutoCloseable {
  private static final long CONTEXT = 0x1122334455667788L;

  private final Socket socket;
  private int session;

  EipClient(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
  }

  /** A client that has registered. */
  static EipClient registered(int port) throws IOException {
    EipClient client = new EipClient(port);
    client.session = client.ask(Encapsulation.REGISTER_SESSION, "0100 0000").session();
    return client;
  }

  void send(byte[] bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  EncapsulationFrame ask(int command, String dataHex) throws IOException {
    send(new EncapsulationFrame(command, session, 0, CONTEXT, 0, Hex.buffer(dataHex)).encode());
    return receive();
  }

  EncapsulationFrame receive() throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    byte[] header = in.readNBytes(EncapsulationFrame.HEADER);
    if (header.length < EncapsulationFrame.HEADER) {
      throw new IOException("the connection has ended");
    }
    int length =
        Short.toUnsignedInt(ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN).getShort(2));
    byte[] all = new byte[header.length + length];
    System.arraycopy(header, 0, all, 0, header.length);
    in.readFully(all, header.length, length);
    return EncapsulationFrame.decode(ByteBuffer.wrap(all));
  }

  /** Sends a message without a connection; answers the one that comes back. */
  String message(String hex) throws IOException {
    return Hex.text(
        PacketItem.first(exchange(hex, List.of()), PacketItem.UNCONNECTED_DATA)
            .orElseThrow()
            .data());
  }

  /** Sends a message with more items; answers all that come back. */
  List<PacketItem> exchange(String hex, List<PacketItem> more) throws IOException {
    LittleEndian data = new LittleEndian().u32(0).u16(0);
    List<PacketItem> items = new ArrayList<>();
    items.add(new PacketItem(PacketItem.NO_ADDRESS, Hex.buffer("")));
    items.add(new PacketItem(PacketItem.UNCONNECTED_DATA, Hex.buffer(hex)));
    items.addAll(more);
    EncapsulationFrame answer =
        ask(Encapsulation.SEND_RR_DATA, Hex.text(PacketItem.encode(data, items).toArray()));
    ByteBuffer bytes = answer.data();
    Optional<List<PacketItem>> decoded = PacketItem.decode(bytes.slice(6, bytes.remaining() - 6));
    return decoded.orElseThrow();
  }

  /** Whether the other side ends the connection. */
  boolean ended() throws IOException {
    return socket.getInputStream().read() < 0;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
