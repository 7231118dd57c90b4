package org.pendant.desktop.ports;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.temporal.ChronoUnit;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;

/** Message detail: all of a message, or what is known of a client, as text. */
final class MessageDetail {
  private static final int MAX_BYTES = 512;
  private static final int ROW_BYTES = 16;
  private static final HexFormat HEX = HexFormat.ofDelimiter(" ");
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss.SSSSSS", Locale.ROOT);

  private MessageDetail() {}

  /** A message with its parts and bytes. */
  static String of(WireMessage message) {
    StringBuilder text = new StringBuilder();
    text.append(MessageWords.summary(message.reading())).append('\n');
    message
        .reading()
        .effect()
        .ifPresent(
            each ->
                text.append(
                        PortsTexts.text("effectIs", MessageWords.shown(message.reading(), each)))
                    .append('\n'));
    Instant time = Instant.EPOCH.plus(message.epochUs(), ChronoUnit.MICROS);
    text.append(
        String.format(
            Locale.ROOT,
            PortsTexts.text("whenAndWhere"),
            message.peers().port(),
            message.peers().client(),
            PortsTexts.text(message.direction() == Direction.IN ? "comingIn" : "goingOut"),
            message.robotTimeS(),
            TIME.format(time.atZone(ZoneId.systemDefault()))));
    text.append('\n');
    members("", message.fields(), text);
    text.append('\n').append(PortsTexts.text("bytes", message.bytes().remaining())).append('\n');
    bytes(message.bytes(), text);
    return text.toString();
  }

  private static void members(String before, Map<?, ?> members, StringBuilder text) {
    members.forEach(
        (name, value) -> {
          if (value instanceof Map<?, ?> parts) {
            text.append(before).append(name).append('\n');
            members(before + "  ", parts, text);
          } else {
            text.append(before).append(name).append(" = ").append(value).append('\n');
          }
        });
  }

  private static void bytes(ByteBuffer bytes, StringBuilder text) {
    byte[] first = new byte[Math.min(MAX_BYTES, bytes.remaining())];
    bytes.duplicate().get(first);
    for (int from = 0; from < first.length; from += ROW_BYTES) {
      int to = Math.min(first.length, from + ROW_BYTES);
      text.append(String.format(Locale.ROOT, "%04x  ", from));
      text.append(HEX.formatHex(first, from, to));
      text.append(" ".repeat(3 * (ROW_BYTES - to + from) + 2));
      for (int i = from; i < to; i++) {
        text.append(first[i] >= ' ' && first[i] < 0x7F ? (char) first[i] : '.');
      }
      text.append('\n');
    }
    if (bytes.remaining() > MAX_BYTES) {
      text.append("\u2026\n");
    }
  }

  /** A client. */
  static String of(ClientRow client) {
    StringBuilder text = new StringBuilder();
    text.append(PortsTexts.text("clientOf", client.peers().port(), client.peers().client()));
    text.append('\n');
    if (!client.data().isEmpty()) {
      text.append('\n').append(PortsTexts.text("getsData", client.data())).append('\n');
      text.append(lines(client.reads()));
    }
    if (!client.writes().isEmpty()) {
      text.append('\n').append(PortsTexts.text("onlyItMayWriteThese")).append('\n');
      text.append(lines(client.writes()));
    }
    return text.toString();
  }

  private static String lines(List<String> names) {
    return "  " + String.join("\n  ", names) + "\n";
  }
}
