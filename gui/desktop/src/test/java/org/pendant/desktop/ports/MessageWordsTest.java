package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.modbus.ModbusDissector;
import org.pendant.protocols.script.ScriptDissector;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.LineDissector;
import org.pendant.protocols.wire.Reading;
import org.pendant.text.Language;
import org.pendant.text.MessageTranslator;

final class MessageWordsTest {
  private final MessageTranslator german = new MessageTranslator(Language.GERMAN);

  @Test
  void whatIsToldOfMessagesIsTranslated() {
    Reading write = read(new ModbusDissector(), 0, 7, 0, 0, 0, 6, 255, 6, 0, 128, 0, 42);
    assertEquals("Register 128 = 42", german(write, write.summary()));
    assertEquals("setzt Register 128 = 42", german(write, write.effect().orElseThrow()));
    Reading bytes = read(Dissector.raw(), 1, 2, 3);
    assertEquals("3 Byte", german(bytes, bytes.summary()));
  }

  @Test
  void whatPeersHaveWrittenStays() {
    // each is a text of ours, too
    Reading line = read(new LineDissector(Optional::of), "connected\n");
    assertEquals("connected", german(line, line.summary()));
    assertEquals("connected", german(line, line.effect().orElseThrow()));
    Reading script = read(new ScriptDissector(true), "done\n");
    assertEquals("done", german(script, script.summary()));
    assertEquals("sendet die Zeile done", german(script, script.effect().orElseThrow()));
  }

  private String german(Reading reading, String said) {
    return MessageWords.shown(reading, said, german::shown);
  }

  private static Reading read(Dissector dissector, String text) {
    return dissector.read(
        Direction.IN, ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1)));
  }

  private static Reading read(Dissector dissector, int... bytes) {
    ByteBuffer message = ByteBuffer.allocate(bytes.length);
    for (int each : bytes) {
      message.put((byte) each);
    }
    return dissector.read(Direction.IN, message.flip());
  }
}
