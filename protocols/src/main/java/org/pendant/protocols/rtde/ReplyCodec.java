package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.pendant.controller.state.SoftwareVersion;

/** Reply codec: what is sent to clients, as packages. */
final class ReplyCodec {
  private static final String SOURCE = "RTDE";
  private static final int MAX_TEXT = 255;

  private ReplyCodec() {}

  /** An empty package; what follows is to be put after its header. */
  static ByteBuffer packet(int type, int payloadBytes) {
    int size = Packet.HEADER_BYTES + payloadBytes;
    return ByteBuffer.allocate(size).putShort((short) size).put((byte) type);
  }

  /**
   * The answer to a yes-or-no question.
   *
   * @param type of the question
   */
  static byte[] accepted(int type, boolean accepted) {
    return packet(type, 1).put((byte) (accepted ? 1 : 0)).array();
  }

  static byte[] controllerVersion(SoftwareVersion version) {
    return packet(PacketType.CONTROLLER_VERSION, 4 * Integer.BYTES)
        .putInt(version.major())
        .putInt(version.minor())
        .putInt(version.bugfix())
        .putInt(version.build())
        .array();
  }

  /** The answer to a recipe of version 2, and to one of inputs. */
  static byte[] recipe(int type, int id, List<String> types) {
    byte[] text = joined(types);
    return packet(type, 1 + text.length).put((byte) id).put(text).array();
  }

  /** The answer to a recipe of outputs of version 1, which has no number. */
  static byte[] recipe(int type, List<String> types) {
    byte[] text = joined(types);
    return packet(type, text.length).put(text).array();
  }

  private static byte[] joined(List<String> types) {
    return bytes(String.join(",", types));
  }

  /**
   * A text message; a text that is too long loses its end.
   *
   * @param version of the protocol that is spoken, 1 or 2
   */
  static byte[] text(TextLevel level, String text, int version) {
    byte[] message = bytes(text.substring(0, Math.min(MAX_TEXT, text.length())));
    if (version == 1) {
      return packet(PacketType.TEXT_MESSAGE, 1 + message.length)
          .put((byte) level.number())
          .put(message)
          .array();
    }
    byte[] source = bytes(SOURCE);
    return packet(PacketType.TEXT_MESSAGE, 3 + message.length + source.length)
        .put((byte) message.length)
        .put(message)
        .put((byte) source.length)
        .put(source)
        .put((byte) level.number())
        .array();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }
}
