package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;

/** Speaks to an RTDE server as a program outside does. */
public final class Client implements AutoCloseable {
  /** Only a server that is broken lets a client wait that long. */
  private static final int GIVE_UP_MS = 20_000;

  private final Socket socket;
  private final DataInputStream in;

  Client(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(GIVE_UP_MS);
    in = new DataInputStream(socket.getInputStream());
  }

  /** With protocol version 2. */
  public static Client speaking2(int port) throws IOException {
    Client client = new Client(port);
    client.send('V', new byte[] {0, 2});
    assertEquals("V 01", client.answer());
    return client;
  }

  /** Sends a package. */
  public void send(int type, byte[] payload) throws IOException {
    ByteBuffer packet = ByteBuffer.allocate(3 + payload.length);
    packet.putShort((short) (3 + payload.length)).put((byte) type).put(payload);
    socket.getOutputStream().write(packet.array());
  }

  void sendRaw(byte[] bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  void send(int type) throws IOException {
    send(type, new byte[0]);
  }

  /** Asks for outputs; says the recipe's number and the types. */
  String outputs(double frequencyHz, String names) throws IOException {
    byte[] text = names.getBytes(StandardCharsets.ISO_8859_1);
    send('O', ByteBuffer.allocate(8 + text.length).putDouble(frequencyHz).put(text).array());
    return recipe('O');
  }

  /** Asks for inputs; says the recipe's number and the types. */
  public String inputs(String names) throws IOException {
    send('I', names.getBytes(StandardCharsets.ISO_8859_1));
    return recipe('I');
  }

  private String recipe(int type) throws IOException {
    Packet packet = next();
    assertEquals(type, packet.type());
    int id = packet.payload().get();
    return id + " " + StandardCharsets.ISO_8859_1.decode(packet.payload());
  }

  /** The next package. */
  Packet next() throws IOException {
    byte[] rest = new byte[in.readUnsignedShort() - 3];
    int type = in.readUnsignedByte();
    in.readFully(rest);
    return new Packet(type, ByteBuffer.wrap(rest));
  }

  /** The next package, its payload in hex. */
  String answer() throws IOException {
    Packet packet = next();
    byte[] payload = new byte[packet.payload().remaining()];
    packet.payload().get(payload);
    return (char) packet.type() + " " + HexFormat.of().formatHex(payload);
  }

  /** The text of the next package, which is a text message of version 2. */
  String text() throws IOException {
    Packet packet = next();
    assertEquals('M', packet.type());
    byte[] text = new byte[Byte.toUnsignedInt(packet.payload().get())];
    packet.payload().get(text);
    return new String(text, StandardCharsets.ISO_8859_1);
  }

  /** Whether the server has closed the connection. */
  boolean ended() throws IOException {
    return in.read() < 0;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
