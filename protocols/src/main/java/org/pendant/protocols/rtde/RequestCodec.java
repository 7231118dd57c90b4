package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Request codec: packages of clients as requests. */
final class RequestCodec {
  /** Most bytes that the names of a recipe may take together. */
  static final int MAX_NAMES = 16_384;

  /** How often version 1 sends, Hz: its requests name no frequency. */
  static final double VERSION_1_HZ = 125;

  private RequestCodec() {}

  /**
   * Decodes a package.
   *
   * @param version of the protocol that is spoken, 1 or 2
   */
  static RtdeRequest decode(Packet packet, int version) {
    ByteBuffer payload = packet.payload();
    return switch (packet.type()) {
      case PacketType.PROTOCOL_VERSION ->
          payload.remaining() == Short.BYTES
              ? new RtdeRequest.ProtocolVersion(Short.toUnsignedInt(payload.getShort()))
              : wrongLength("wrongProtocolVersion", payload);
      case PacketType.CONTROLLER_VERSION ->
          empty("wrongControllerVersion", payload, new RtdeRequest.ControllerVersion());
      case PacketType.SETUP_OUTPUTS -> outputs(payload, version);
      case PacketType.SETUP_INPUTS -> inputs(payload);
      case PacketType.START -> empty("wrongStart", payload, new RtdeRequest.Start());
      case PacketType.PAUSE -> empty("wrongPause", payload, new RtdeRequest.Pause());
      case PacketType.DATA ->
          payload.hasRemaining()
              ? new RtdeRequest.Data(Byte.toUnsignedInt(payload.get()), payload)
              : wrongLength("wrongData", payload);
      case PacketType.TEXT_MESSAGE -> version == 1 ? plainText(payload) : text(payload);
      default ->
          new RtdeRequest.Malformed(
              TextLevel.WARNING, RtdeTexts.text("unknownType", packet.type()));
    };
  }

  private static RtdeRequest empty(String complaint, ByteBuffer payload, RtdeRequest request) {
    return payload.hasRemaining() ? wrongLength(complaint, payload) : request;
  }

  private static RtdeRequest wrongLength(String complaint, ByteBuffer payload) {
    return new RtdeRequest.Malformed(
        TextLevel.ERROR, RtdeTexts.text(complaint, payload.remaining()));
  }

  private static RtdeRequest outputs(ByteBuffer payload, int version) {
    if (version == 1) {
      return names(
          PacketType.SETUP_OUTPUTS,
          payload,
          names -> new RtdeRequest.SetupOutputs(VERSION_1_HZ, names));
    }
    if (payload.remaining() < Double.BYTES) {
      return wrongLength("wrongOutputRecipe", payload);
    }
    double frequencyHz = payload.getDouble();
    return names(
        PacketType.SETUP_OUTPUTS,
        payload,
        names -> new RtdeRequest.SetupOutputs(frequencyHz, names));
  }

  private static RtdeRequest inputs(ByteBuffer payload) {
    return names(PacketType.SETUP_INPUTS, payload, RtdeRequest.SetupInputs::new);
  }

  private interface Named {
    RtdeRequest with(List<String> names);
  }

  private static RtdeRequest names(int type, ByteBuffer payload, Named request) {
    if (payload.remaining() > MAX_NAMES) {
      return new RtdeRequest.RefusedSetup(
          type, RtdeTexts.text("namesTooLong", payload.remaining(), MAX_NAMES));
    }
    List<String> names = split(StandardCharsets.ISO_8859_1.decode(payload).toString());
    return names.isEmpty()
        ? new RtdeRequest.Malformed(TextLevel.ERROR, RtdeTexts.text("recipeWithoutVariable"))
        : request.with(names);
  }

  /** The names between commas; some clients write a comma after the last one as well. */
  private static List<String> split(String text) {
    List<String> names = new ArrayList<>();
    int from = 0;
    for (int comma = text.indexOf(','); comma >= 0; comma = text.indexOf(',', from)) {
      names.add(text.substring(from, comma));
      from = comma + 1;
    }
    if (from < text.length()) {
      names.add(text.substring(from));
    }
    return names;
  }

  private static RtdeRequest text(ByteBuffer payload) {
    int length = payload.remaining();
    int message = skipText(payload, 0);
    int source = skipText(payload, message);
    if (source < 0 || source + 1 != length) {
      return wrongLength("wrongTextMessage", payload);
    }
    String said = StandardCharsets.ISO_8859_1.decode(payload.slice(1, message - 1)).toString();
    String by =
        StandardCharsets.ISO_8859_1
            .decode(payload.slice(message + 1, source - message - 1))
            .toString();
    return new RtdeRequest.Text(
        TextLevel.of(payload.get(source)), by.isEmpty() ? said : by + ": " + said);
  }

  /** Where a text ends that begins with its length at {@code from}; -1 when it is cut off. */
  private static int skipText(ByteBuffer payload, int from) {
    if (from < 0 || from >= payload.limit()) {
      return -1;
    }
    int end = from + 1 + Byte.toUnsignedInt(payload.get(from));
    return end > payload.limit() ? -1 : end;
  }

  private static RtdeRequest plainText(ByteBuffer payload) {
    if (!payload.hasRemaining()) {
      return wrongLength("wrongPlainTextMessage", payload);
    }
    TextLevel level = TextLevel.of(payload.get());
    return new RtdeRequest.Text(level, StandardCharsets.ISO_8859_1.decode(payload).toString());
  }
}
