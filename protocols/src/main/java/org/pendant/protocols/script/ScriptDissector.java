package org.pendant.protocols.script;

import static org.pendant.protocols.script.ReceivedScriptTexts.text;

import java.nio.ByteBuffer;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/**
 * Script dissector: programs and lines that clients send, by the column rule of {@link
 * ScriptFramer}.
 *
 * @param obeyed whether the port runs what it is sent
 */
public record ScriptDissector(boolean obeyed) implements Dissector {

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    int end = lineEnd(bytes, bytes.position());
    if (end == MORE || !begins(bytes, bytes.position(), "def", "sec")) {
      return end == MORE ? MORE : end - bytes.position();
    }
    while (end != MORE && end < bytes.limit()) {
      int line = end;
      end = lineEnd(bytes, line);
      if (end != MORE && begins(bytes, line, "end")) {
        return end - bytes.position();
      }
    }
    return MORE;
  }

  private static int lineEnd(ByteBuffer bytes, int from) {
    for (int i = from; i < bytes.limit(); i++) {
      if (bytes.get(i) == '\n') {
        return i + 1;
      }
    }
    return MORE;
  }

  /** Whether one of the words stands in the first column, and no longer word. */
  private static boolean begins(ByteBuffer bytes, int from, String... words) {
    for (String word : words) {
      int at = 0;
      while (at < word.length()
          && from + at < bytes.limit()
          && bytes.get(from + at) == word.charAt(at)) {
        at++;
      }
      if (at == word.length() && from + at < bytes.limit()) {
        char next = (char) Byte.toUnsignedInt(bytes.get(from + at));
        return !(Character.isLetterOrDigit(next) || next == '_');
      }
    }
    return false;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    String text = Dissector.text(message);
    Reading reading =
        begins(message, message.position(), "def", "sec") ? program(text) : line(text.strip());
    return obeyed ? reading : reading.doingNothing();
  }

  private static Reading program(String text) {
    String head = text.lines().findFirst().orElse("").strip();
    long lines = text.lines().count();
    return Reading.of(
            "program",
            text("programOfLines", head, lines),
            () -> Fields.of("lines", lines, "text", text))
        .doing(text("sendsTheProgram", head));
  }

  private static Reading line(String text) {
    if (text.isEmpty() || text.startsWith("#")) {
      return Reading.quoting("comment", text, () -> Fields.of("text", text));
    }
    boolean command = RawCommand.read(text).isPresent();
    return Reading.quoting(command ? "command" : "line", text, () -> Fields.of("text", text))
        .doing(command ? text : text("sendsTheLine", text));
  }
}
