package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * Packet wire: packets on a plain TCP connection, the form of XML-RPC that the manual calls pstream
 * (18.40). An escape byte and a word of three letters stand for the begin and the end of a packet,
 * for nothing, and for the escape byte itself.
 */
final class PacketWire implements Wire {
  private static final int ESCAPE = 0x1B;
  private static final int WORD = 3;
  private static final String BEGIN = "PKT";
  private static final String END = "END";
  private static final String NOTHING = "NOP";
  private static final String LITERAL = "ESC";

  private final RpcConnection line;

  PacketWire(RpcConnection line) {
    this.line = line;
  }

  @Override
  public void probe() throws IOException {
    line.connect();
  }

  @Override
  public byte[] exchange(byte[] call) throws IOException {
    line.connect();
    try {
      line.send(packet(call));
      if (!line.awaitAnswer()) {
        throw new EOFException(text("closedWithoutAnswer"));
      }
      return answer();
    } catch (IOException e) {
      // what comes later would be taken for the answer to the next call
      line.close();
      throw e;
    }
  }

  /** {@code content} as a packet. */
  static byte[] packet(byte[] content) {
    ByteArrayOutputStream packet = new ByteArrayOutputStream(content.length + 16);
    escape(packet, BEGIN);
    for (byte next : content) {
      if (next == ESCAPE) {
        escape(packet, LITERAL);
      } else {
        packet.write(next);
      }
    }
    escape(packet, END);
    return packet.toByteArray();
  }

  private static void escape(ByteArrayOutputStream out, String word) {
    out.write(ESCAPE);
    out.writeBytes(word.getBytes(StandardCharsets.US_ASCII));
  }

  private byte[] answer() throws IOException {
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    boolean begun = false;
    while (true) {
      int next = RpcConnection.orEnd(line.read());
      if (next != ESCAPE) {
        if (!begun) {
          throw new IOException(text("answerBeginsWithoutPacket"));
        }
        content.write(next);
      } else {
        String word = new String(line.read(WORD), StandardCharsets.ISO_8859_1);
        switch (word) {
          case BEGIN -> begun = true;
          case LITERAL -> content.write(ESCAPE);
          case NOTHING -> {}
          case END -> {
            return content.toByteArray();
          }
          default -> throw new IOException(text("answerNoPacket"));
        }
      }
      RpcConnection.bound(content.size());
    }
  }

  @Override
  public void close() {
    line.close();
  }
}
